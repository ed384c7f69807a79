#include "layout.hpp"

#include <algorithm>
#include <numeric>

namespace rotconv::stream {

void Layout::select(std::vector<std::size_t> chosen, std::size_t kept) {
    positions = std::move(chosen);
    in_row_order = positions;
    std::ranges::sort(in_row_order);
    replaced.assign(positions.begin() + static_cast<std::ptrdiff_t>(kept), positions.end());
    std::ranges::sort(replaced);
}

void Layout::select_all(std::size_t count, std::size_t kept) {
    replaced.resize(kept > 0 ? count - kept : 0);
    std::iota(replaced.begin(), replaced.end(), kept);
}

void append_result_names(Buffer& to, const Options& options, char delimiter) {
    const auto& names = options.function.names;
    fmt::format_to(std::back_inserter(to), "{}", fmt::join(names, std::string_view(&delimiter, 1)));
    if (options.diagnostic_columns) {
        for (const std::string_view name : {"margin", "condition", "defect", "notes"}) {
            to.push_back(delimiter);
            append(to, name);
        }
    }
}

Preamble::Preamble(const Options& options)
    : options_(&options), header_done_(options.header == HeaderMode::no || options.header == HeaderMode::add) {
    if (options.columns.empty()) {
        layout_.select_all(options.function.inputs, options.function.kept);
    } else if (!options.columns.has_names()) {
        layout_.select(options.columns.positions(), options.function.kept);
    }
}

bool Preamble::read(std::string_view& rest, std::size_t& line, Output& output) {
    if (options_->width > 0) {
        layout_.delimiter = options_->delimiter.value_or(Delimiter::character(','));
        if (options_->header == HeaderMode::add) {
            write_added_header(options_->width, output);
        }
        return true;
    }
    while (!rest.empty()) {
        std::string_view after = rest;
        const Line current = next_line(after);
        const Role role = role_of(current, line);
        if (fault_) {
            return false;
        }
        if (role == Role::data) {
            layout_.delimiter = options_->delimiter.value_or(Delimiter::of_row(current.text));
            layout_.line_end = current.end.empty() ? "\n" : std::string(current.end);
            if (options_->header == HeaderMode::add) {
                header_fields_.clear();
                layout_.delimiter.split(current.text, header_fields_);
                write_added_header(header_fields_.size(), output);
            }
            return true;
        }
        if (options_->format == Format::csv) {
            if (role == Role::header) {
                write_header(current, output);
            } else {
                append(output.bytes, current.text);
                append(output.bytes, current.end);
            }
        }
        rest = after;
        ++line;
    }
    return false;
}

void Preamble::finish(Output& output) {
    if (options_->header == HeaderMode::add && options_->format == Format::csv && options_->columns.empty()) {
        const char delimiter = options_->delimiter.value_or(Delimiter::character(',')).text();
        for (std::size_t i = 0; i < options_->function.kept; ++i) {
            fmt::format_to(std::back_inserter(output.bytes), "{}{}", i + 1, delimiter);
        }
        append_result_names(output.bytes, *options_, delimiter);
        output.bytes.push_back('\n');
    }
}

Preamble::Role Preamble::role_of(const Line& line, std::size_t number) {
    if (is_blank(line.text)) {
        return Role::passed;
    }
    if (header_done_) {
        return is_comment(line.text) ? Role::passed : Role::data;
    }
    if (options_->columns.has_names()) {
        return role_by_name(line, number);
    }
    if (is_comment(line.text) && options_->header != HeaderMode::yes) {
        return Role::passed;
    }
    split_header(line.text);
    if (is_comment(line.text)) {
        // A header may begin with '#' where the user says that there is one; a comment has not the fields of one.
        header_done_ = has_selected_fields();
        return header_done_ ? Role::header : Role::passed;
    }
    header_done_ = true;
    const bool is_header = options_->header == HeaderMode::yes || (has_selected_fields() && !has_selected_number());
    if (!is_header) {
        layout_.header.clear();
    }
    return is_header ? Role::header : Role::data;
}

Preamble::Role Preamble::role_by_name(const Line& line, std::size_t number) {
    split_header(line.text);
    auto looked_up = options_->columns.positions(layout_.header);
    if (auto* positions = std::get_if<std::vector<std::size_t>>(&looked_up)) {
        layout_.select(std::move(*positions), options_->function.kept);
        header_done_ = true;
        return Role::header;
    }
    if (!is_comment(line.text)) {
        fault_ = StreamFault{StreamFault::What::columns, number, 0, std::get<ColumnFault>(looked_up)};
    }
    return Role::passed;
}

void Preamble::split_header(std::string_view text) {
    const std::size_t prefix = is_comment(text) ? std::min(text.find_first_not_of(" \t", 1), text.size()) : 0;
    header_prefix_ = text.substr(0, prefix);
    const std::string_view names = text.substr(prefix);
    header_delimiter_ = options_->delimiter.value_or(Delimiter::of_row(names));
    header_fields_.clear();
    header_delimiter_.split(names, header_fields_);
    layout_.header.clear();
    std::ranges::transform(header_fields_, std::back_inserter(layout_.header), [this](std::string_view field) {
        return std::string(trimmed(header_delimiter_.unquoted(trimmed(field))));
    });
}

bool Preamble::has_selected_fields() const noexcept {
    return layout_.positions.empty() ? header_fields_.size() == options_->function.inputs
                                     : layout_.in_row_order.back() < header_fields_.size();
}

bool Preamble::has_selected_number() const noexcept {
    if (layout_.positions.empty()) {
        return std::ranges::any_of(header_fields_,
                                   [this](auto field) { return is_number(header_delimiter_.text_of(field)); });
    }
    return std::ranges::any_of(
        layout_.positions, [this](std::size_t at) { return is_number(header_delimiter_.text_of(header_fields_[at])); });
}

void Preamble::write_header(const Line& line, Output& output) const {
    const char delimiter = header_delimiter_.text();
    Buffer& to = output.bytes;
    const auto write_result = [&] { append_result_names(to, *options_, delimiter); };
    if (options_->append) {
        write_appended(to, line.text, delimiter, write_result);
    } else {
        append(to, header_prefix_);
        write_fields(to, layout_, header_fields_, delimiter, write_result);
    }
    append(to, line.end.empty() ? std::string_view("\n") : line.end);
}

void Preamble::write_added_header(std::size_t field_count, Output& output) const {
    if (options_->format != Format::csv) {
        return;
    }
    const char delimiter = layout_.delimiter.text();
    std::vector<std::string> indices;
    for (std::size_t i = 0; i < field_count; ++i) {
        indices.push_back(std::to_string(i + 1));
    }
    Buffer& to = output.bytes;
    const auto write_result = [&] { append_result_names(to, *options_, delimiter); };
    if (options_->append) {
        write_appended(to, fmt::format("{}", fmt::join(indices, std::string_view(&delimiter, 1))), delimiter,
                       write_result);
    } else {
        write_fields(to, layout_, indices, delimiter, write_result);
    }
    append(to, layout_.line_end);
}

} // namespace rotconv::stream
