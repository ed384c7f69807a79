#include "option_set.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>

#include "usage.hpp"
#include "words.hpp"

namespace rotconv::cli {
namespace {

/// CLI11 does not know of VALUEs.
class Formatter : public CLI::Formatter {
public:
    explicit Formatter(std::string usage) : usage_(std::move(usage)) {}
    std::string make_usage(const CLI::App* /*app*/, std::string /*name*/) const override { return usage_; }

private:
    std::string usage_;
};

void define(CLI::App& app, const OptionSet& options) {
    app.set_help_flag();
    for (const Option& option : options.all()) {
        app.option_defaults()->group(option.group);
        if (auto* const* flag = std::get_if<bool*>(&option.value)) {
            app.add_flag(option.names, **flag, option.about);
        } else if (auto* const* text = std::get_if<std::string*>(&option.value)) {
            app.add_option(option.names, **text, option.about)->type_name(option.argument);
        } else {
            app.add_option(option.names, *std::get<std::vector<std::string>*>(option.value), option.about)
                ->type_name("");
        }
    }
}

} // namespace

std::vector<std::string> Option::each_name() const {
    const auto comma = names.find(',');
    return comma == std::string::npos ? std::vector{names}
                                      : std::vector{names.substr(0, comma), names.substr(comma + 1)};
}

void OptionSet::add(std::string_view names, std::string& value, std::string_view argument, std::string_view about) {
    options_.push_back({std::string(names), std::string(argument), std::string(about), group_, &value});
}

void OptionSet::add(std::string_view names, bool& value, std::string_view about) {
    options_.push_back({std::string(names), {}, std::string(about), group_, &value});
}

void OptionSet::add_operands(std::string_view name, std::vector<std::string>& value, std::string_view about) {
    options_.push_back({std::string(name), {}, std::string(about), group_, &value});
}

void OptionSet::describe(std::string_view name, std::string_view about) {
    std::ranges::for_each(options_,
                          [&](Option& option) { option.about = option.name() == name ? about : option.about; });
}

const Option* OptionSet::find(std::string_view name) const {
    const auto found = std::ranges::find_if(
        options_, [&](const Option& option) { return std::ranges::count(option.each_name(), name) > 0; });
    return found == options_.end() ? nullptr : &*found;
}

bool OptionSet::takes_operands() const { return std::ranges::any_of(options_, &Option::is_operand); }

std::vector<std::string> OptionSet::read(std::vector<std::string> words) const {
    CLI::App app;
    define(app, *this);
    app.allow_extras();
    std::ranges::reverse(words); // as CLI11 wants them
    try {
        app.parse(words);
    } catch (const CLI::ParseError& error) {
        throw Usage(shown(error.what()));
    }
    return app.remaining();
}

std::string help_of(const OptionSet& options, const HelpText& text) {
    CLI::App app(text.about);
    app.formatter(std::make_shared<Formatter>(text.usage));
    define(app, options);
    for (const auto& [name, about] : text.commands) {
        app.add_subcommand(name, about)->group("Commands");
    }
    app.footer(text.footer);
    std::string help = app.help();
    for (auto at = help.find("\n\n\n"); at != std::string::npos; at = help.find("\n\n\n")) {
        help.erase(at, 1); // CLI11 ends a group with two
    }
    return help;
}

} // namespace rotconv::cli
