#include "sinew/io/field_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sinew/io/text_numbers.h"
#include "sinew/skeleton/validate.h"

namespace sinew {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

}  // namespace

FieldReader::FieldReader(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    at_ = line_start_ = line_end_ = field_ = next_ = text.data();
    end_ = at_ + text.size();
}

bool FieldReader::next_line() {
    while (at_ != end_) {
        ++line_;
        line_start_ = at_;
        at_ = std::find_if(at_, end_, is_line_end);
        line_end_ = std::find(line_start_, at_, '#');
        if (at_ != end_) at_ += *at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n' ? 2 : 1;
        field_ = next_ = std::find_if_not(line_start_, line_end_, is_space);
        if (next_ != line_end_) return true;
    }
    return false;
}

std::string_view FieldReader::next_field() {
    field_ = std::find_if_not(next_, line_end_, is_space);
    next_ = std::find_if(field_, line_end_, is_space);
    return {field_, next_};
}

Result<double> FieldReader::number(std::string_view name) {
    const std::string_view field = next_field();
    double value = 0;
    if (field.empty())
        return fail_here(fmt::format("the line ends before the {}", name), "give all fields of the line");
    if (scan_double(field.data(), next_, value) != next_)
        return fail_here(fmt::format("the {} is no number: {}", name, shown(field)), "write a number");
    if (!(std::abs(value) <= largest_length))
        return fail_here(
            fmt::format("the {} is {}", name, std::isnan(value) ? "not a number (nan)" : "too large"),
            "write a finite number of at most 1e30");
    return value;
}

Result<std::int64_t> FieldReader::integer(std::string_view name) {
    const std::string_view field = next_field();
    std::int64_t value = 0;
    if (field.empty())
        return fail_here(fmt::format("the line ends before the {}", name), "give all fields of the line");
    if (scan_integer(field.data(), next_, value) == next_) return value;
    double real = 0;
    if (scan_double(field.data(), next_, real) == next_ && std::abs(real) <= 0x1p53 &&
        real == std::floor(real))
        return static_cast<std::int64_t>(real);
    return fail_here(fmt::format("the {} is no integer: {}", name, shown(field)), "write an integer");
}

tl::unexpected<Error> FieldReader::fail_here(std::string message, std::string cure) const {
    return fail(Error{.message = std::move(message),
                      .cure = std::move(cure),
                      .line = line_,
                      .column = field_ - line_start_ + 1});
}

std::string shown(std::string_view text) {
    std::string start(text.substr(0, 30));
    for (char& c : start)
        if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
    return text.size() > 30 ? start + "..." : start;
}

}  // namespace sinew
