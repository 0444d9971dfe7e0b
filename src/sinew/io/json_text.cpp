#include "sinew/io/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sinew {
namespace {

/// A pointer into the text that tells somebody else how far the parser has come.
struct WatchedPointer {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at;
    const char** furthest;

    const char& operator*() const { return *at; }
    WatchedPointer& operator++() {
        *furthest = ++at;
        return *this;
    }
    bool operator==(const WatchedPointer& other) const { return at == other.at; }
    bool operator!=(const WatchedPointer& other) const { return at != other.at; }
};

template <class Handler>
bool parse(std::string_view text, Handler& handler, const char** furthest) {
    const char* end = text.data() + text.size();
    return Json::sax_parse(WatchedPointer{text.data(), furthest}, WatchedPointer{end, furthest}, &handler);
}

/// Builds the values, and says what is wrong.
class Builder : public nlohmann::json_sax<Json> {
  public:
    explicit Builder(std::string_view text) : text_(text) {}

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool number_float(number_float_t value, const string_t&) override { return put(value); }
    bool string(string_t& value) override { return put(std::move(value)); }
    bool binary(binary_t&) override { return false; }  // never in text
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        object().emplace_back(std::move(name), nullptr);
        return true;
    }
    bool end_object() override {
        if (const std::string* twice = repeated_key()) {
            error_.message = fmt::format("the key \"{}\" is given twice", *twice);
            error_.cure = "remove one of the two";
            error_.path = pointer() + "/" + pointer_step(*twice);
            return false;
        }
        return close();
    }
    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::detail::exception& ex) override {
        const std::string_view before =
            text_.substr(0, std::min(position > 0 ? position - 1 : 0, text_.size()));
        error_.line = 1 + std::ranges::count(before, '\n');
        error_.column = static_cast<std::int64_t>(before.size() - (before.rfind('\n') + 1)) + 1;
        const bool overflow = ex.id == 406;
        error_.message = overflow ? "a number is too large" : "this is not JSON: " + reason(ex.what());
        error_.cure = overflow ? "stay below 1.8e308" : "correct the text there";
        return false;
    }

    Json root;
    Error take_error() { return std::move(error_); }

  private:
    Json::object_t& object() { return stack_.back()->get_ref<Json::object_t&>(); }

    Json* put(Json value) {
        if (stack_.empty()) return &(root = std::move(value));
        Json& parent = *stack_.back();
        if (parent.is_array()) return &parent.get_ref<Json::array_t&>().emplace_back(std::move(value));
        return &(object().back().second = std::move(value));
    }
    bool open(Json container) {
        if (stack_.size() == deepest_json) {
            error_.message =
                fmt::format("arrays and objects stand in one another more than {} deep", deepest_json);
            error_.cure = "this is no sensible document";
            error_.path = pointer();
            error_.path.resize(std::min<std::size_t>(error_.path.size(), 60));
            return false;
        }
        stack_.push_back(put(std::move(container)));
        return true;
    }
    bool close() {
        stack_.pop_back();
        return true;
    }

    /// Of the container that is open: its ancestors' last entries lead to it.
    std::string pointer() const {
        std::string path;
        for (std::size_t depth = 0; depth + 1 < stack_.size(); ++depth) {
            const Json& value = *stack_[depth];
            path += "/";
            path += value.is_array() ? fmt::format("{}", value.size() - 1)
                                     : pointer_step(value.get_ref<const Json::object_t&>().back().first);
        }
        return path;
    }

    const std::string* repeated_key() {
        keys_.clear();
        for (const auto& [name, value] : object()) keys_.push_back(&name);
        auto less = [](const std::string* a, const std::string* b) { return *a < *b; };
        std::ranges::stable_sort(keys_, less);
        auto twice = std::ranges::adjacent_find(keys_, [](auto* a, auto* b) { return *a == *b; });
        return twice == keys_.end() ? nullptr : *twice;
    }

    /// "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error ...": what follows the
    /// place, in a bearable length and without what a terminal might obey.
    static std::string reason(std::string_view what) {
        const std::size_t place = what.find(": ");
        std::string text(place == std::string_view::npos ? what : what.substr(place + 2));
        for (char& c : text)
            if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
        return text.size() > 200 ? text.substr(0, 200) + "..." : text;
    }

    std::string_view text_;
    Error error_;
    std::vector<Json*> stack_;
    std::vector<const std::string*> keys_;
};

/// Follows the text down to the value that a pointer names and remembers where that starts.
class Locator : public nlohmann::json_sax<Json> {
  public:
    Locator(std::string_view pointer, const char** furthest) : target_(pointer), furthest_(furthest) {}

    bool null() override { return meet(); }
    bool boolean(bool) override { return meet(); }
    bool number_integer(number_integer_t) override { return meet(); }
    bool number_unsigned(number_unsigned_t) override { return meet(); }
    bool number_float(number_float_t, const string_t&) override { return meet(); }
    bool string(string_t&) override { return meet(); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(-1); }
    bool start_array(std::size_t) override { return open(0); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        step_ = fmt::format("/{}", pointer_step(name));
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

    const char* found = nullptr;

  private:
    struct Level {
        std::size_t path_length;
        std::int64_t next_index;  ///< -1 in an object
    };

    bool meet() {
        if (!levels_.empty() && levels_.back().next_index >= 0)
            step_ = fmt::format("/{}", levels_.back().next_index++);
        path_ += step_;
        const bool on_the_way =
            target_.starts_with(path_) && (target_.size() == path_.size() || target_[path_.size()] == '/');
        if (on_the_way) found = *furthest_;
        path_.resize(path_.size() - step_.size());
        return true;
    }
    bool open(std::int64_t first_index) {
        meet();
        levels_.push_back({path_.size(), first_index});
        path_ += step_;
        return levels_.size() <= deepest_json;
    }
    bool close() {
        path_.resize(levels_.back().path_length);
        levels_.pop_back();
        return true;
    }

    std::string_view target_;
    const char** furthest_;
    std::string path_, step_;
    std::vector<Level> levels_;
};

}  // namespace

Result<Json> parse_json(std::string_view text) try {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return fail(ErrorKind::input, "there is nothing in it", "check that it was saved whole");
    Builder builder(text);
    const char* furthest = text.data();
    if (parse(text, builder, &furthest)) return std::move(builder.root);
    Error error = builder.take_error();
    if (error.line == 0) error.line = 1 + std::count(text.data(), std::max(text.data(), furthest - 1), '\n');
    return fail(std::move(error));
} catch (const std::exception& exception) {  // bad_alloc
    return fail(ErrorKind::program, fmt::format("the JSON text cannot be taken in ({})", exception.what()));
}

std::int64_t line_of(std::string_view text, std::string_view pointer) try {
    const char* furthest = text.data();
    Locator locator(pointer, &furthest);
    parse(text, locator, &furthest);
    // A number ends only with the character behind it, which may be the line's end.
    return locator.found ? 1 + std::count(text.data(), std::max(text.data(), locator.found - 1), '\n') : 0;
} catch (const std::exception&) {
    return 0;
}

std::string pointer_step(std::string_view key) {
    std::string step;
    for (char c : key) {
        if (c == '~')
            step += "~0";
        else if (c == '/')
            step += "~1";
        else
            step += c;
    }
    return step;
}

const Json* find(const Json& object, std::string_view key) {
    for (const auto& [name, value] : object.get_ref<const Json::object_t&>())
        if (name == key) return &value;
    return nullptr;
}

Json without(const Json& object, std::initializer_list<std::string_view> keys) {
    Json rest = Json::object();
    for (const auto& [key, value] : object.get_ref<const Json::object_t&>())
        if (std::ranges::find(keys, key) == keys.end())
            rest.get_ref<Json::object_t&>().emplace_back(key, value);
    return rest;
}

std::optional<std::int64_t> integer_in(const Json& value) {
    if (value.is_number_unsigned()) {
        const auto number = value.get<std::uint64_t>();
        if (number <= std::uint64_t{INT64_MAX}) return static_cast<std::int64_t>(number);
    } else if (value.is_number_integer()) {
        return value.get<std::int64_t>();
    } else if (value.is_number_float()) {
        const double number = value.get<double>();
        if (number == std::floor(number) && std::abs(number) <= 0x1p53)
            return static_cast<std::int64_t>(number);
    }
    return {};
}

}  // namespace sinew
