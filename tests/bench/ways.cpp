#include "ways.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <variant>

#include <rotconv/conversion.hpp>

namespace bench {

using namespace rotconv;

namespace {

Spec spec_of(RepresentationId name, const char* sequence) {
    return std::get<Spec>(
        parse_spec(text_of(name) + (name == RepresentationId::euler ? ':' + std::string(sequence) : "")));
}

/// Without any way yet but Eigen's, the typed call and the fast one.
Pair pair_of(RepresentationId from, RepresentationId to) {
    Pair pair{from, to, {}};
    if (const Run run = eigen_way(from, to, false)) {
        pair.ways.push_back({"Eigen", run, eigen_way(from, to, true)});
    }
    if (const Run run = typed_way(from, to)) {
        pair.ways.push_back({"typed", run, run});
    }
    pair.ways.push_back({std::string(fast_method), nullptr, nullptr});
    return pair;
}

/// rotconv's own way, in blocks as a stream has them.
class Own {
public:
    Own(const Spec& from, const Spec& to, bool fast)
        : conversion_(from, to,
                      {.tolerance = std::numeric_limits<double>::infinity(), .lock_margin = 0.0, .fast = fast}) {}

    void run(const double* in, std::size_t rows, double* out) {
        const std::size_t inputs = conversion_.from().size();
        const std::size_t outputs = conversion_.to().size();
        for (std::size_t first = 0; first < rows; first += block) {
            const std::size_t some = std::min(block, rows - first);
            conversion_.run({in + first * inputs, some * inputs}, {out + first * outputs, some * outputs}, reports_);
        }
    }

private:
    Conversion conversion_;
    std::vector<RowReport> reports_;
};

} // namespace

Convert Way::between(const Spec& from, const Spec& to, bool is_hostile) const {
    if (const Run run = is_hostile ? hostile : clean) {
        const EulerSequence sequence = from.name == RepresentationId::euler ? from.sequence : to.sequence;
        return [run, sequence](const double* in, std::size_t rows, double* out) { run(sequence, in, rows, out); };
    }
    return [own = std::make_shared<Own>(from, to, name == fast_method)](const double* in, std::size_t rows,
                                                                        double* out) { own->run(in, rows, out); };
}

Spec Pair::source(const char* sequence) const { return spec_of(from, sequence); }
Spec Pair::target(const char* sequence) const { return spec_of(to, sequence); }

std::vector<Pair> pairs() {
    std::vector<Pair> found;
    for (const Method& method : methods()) {
        if (found.empty() || found.back().from != method.from || found.back().to != method.to) {
            found.push_back(pair_of(method.from, method.to));
            found.back().ways.push_back({"default", nullptr, nullptr});
        }
        found.back().ways.push_back({std::string(method.name), method.run, method.run});
    }
    // common, and no published method of ours
    for (const RepresentationId from :
         {RepresentationId::euler, RepresentationId::dcm, RepresentationId::five_d, RepresentationId::mrp}) {
        found.push_back(pair_of(from, RepresentationId::dcm));
        found.back().ways.push_back({"default", nullptr, nullptr});
    }
    found.push_back(pair_of(RepresentationId::euler, RepresentationId::quat));
    found.back().ways.push_back({"default", nullptr, nullptr});
    return found;
}

std::string text_of(RepresentationId name) { return std::string(representation(name).text); }

} // namespace bench
