// SPECs that are chosen at run time: chosen FROM TO NUMBER...

#include <cstdlib>
#include <iostream>
#include <variant>
#include <vector>

#include <rotconv/rotconv.hpp>

using namespace rotconv;

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 3) {
        std::cerr << "usage: chosen FROM TO NUMBER...\n";
        return 2;
    }
    const auto from = parse_spec(words[0]);
    const auto to = parse_spec(words[1]);
    for (const auto& parsed : {from, to}) {
        if (const auto* error = std::get_if<SpecError>(&parsed)) {
            std::cerr << message(*error) << '\n';
            return 2;
        }
    }
    const Conversion conversion(std::get<Spec>(from), std::get<Spec>(to));
    std::vector<double> numbers;
    for (std::size_t i = 2; i < words.size(); ++i) {
        numbers.push_back(std::strtod(words[i].c_str(), nullptr));
    }
    std::vector<double> result(conversion.to().size());
    std::vector<RowReport> reports;
    conversion.run(numbers, result, reports); // throws std::invalid_argument if they are not whole rows
    std::cout << conversion.to() << ':';
    for (const double number : result) {
        std::cout << ' ' << number;
    }
    std::cout << '\n';
}
