#include "sinew/io/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "sinew/io/text_numbers.h"

namespace sinew {
namespace {

std::optional<PlyType> type_named(std::string_view name) {
    // Each type has the name it was born with and the one that says its size; both are in use.
    constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                    {"uchar", "uint8"},
                                                                    {"short", "int16"},
                                                                    {"ushort", "uint16"},
                                                                    {"int", "int32"},
                                                                    {"uint", "uint32"},
                                                                    {"float", "float32"},
                                                                    {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (name == names[i][0] || name == names[i][1]) return static_cast<PlyType>(i);
    return std::nullopt;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

class HeaderReader {
  public:
    HeaderReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Result<PlyHeader> read() {
        if (next_line() != "ply") return wrong("this is no PLY file: it does not start with 'ply'");
        bool has_format = false;
        while (header_.size < bytes_.size()) {
            const std::vector<std::string_view> words = words_of(next_line());
            if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
            if (words[0] == "end_header") return has_format ? finish() : wrong("the header names no format");
            has_format |= words[0] == "format";
            if (auto done = read_words(words); !done) return tl::unexpected(done.error());
        }
        return wrong("the header does not end", "is the file cut off?");
    }

  private:
    tl::unexpected<Error> wrong(std::string message, std::string cure = {}) const {
        return fail(Error{.message = std::move(message),
                          .cure = std::move(cure),
                          .file = name_,
                          .line = std::max<std::int64_t>(header_.lines, 1)});
    }

    std::string_view next_line() {
        const std::string_view rest = bytes_.substr(header_.size);
        const std::size_t length = std::min(rest.find_first_of("\r\n"), rest.size());
        const bool two = rest.substr(length).starts_with("\r\n");
        header_.size += std::min(length + (two ? 2 : 1), rest.size());
        ++header_.lines;
        return rest.substr(0, length);
    }

    Result<PlyHeader> finish() {
        // The last line must be whole: what follows it are data.
        if (bytes_[header_.size - 1] != '\n' && bytes_[header_.size - 1] != '\r')
            return wrong("the header does not end", "is the file cut off?");
        return std::move(header_);
    }

    Result<void> read_words(const std::vector<std::string_view>& words) {
        if (words[0] == "format") return read_format(words);
        if (words[0] == "element") return read_element(words);
        if (words[0] == "property") return read_property(words);
        return wrong(fmt::format("'{}' is no keyword of a PLY header", words[0]));
    }

    Result<void> read_format(const std::vector<std::string_view>& words) {
        constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian", "binary_big_endian"};
        const auto found = std::find(names.begin(), names.end(), words.size() == 3 ? words[1] : "");
        if (found == names.end() || words[2] != "1.0")
            return wrong("an unknown format",
                         "format ascii 1.0, binary_little_endian 1.0 and binary_big_endian 1.0 can be read");
        header_.encoding = static_cast<PlyEncoding>(found - names.begin());
        return {};
    }

    Result<void> read_element(const std::vector<std::string_view>& words) {
        PlyElement element;
        const char* const end = words.size() == 3 ? words[2].data() + words[2].size() : nullptr;
        if (!end || scan_integer(words[2].data(), end, element.count) != end || element.count < 0)
            return wrong("an element without a name and a count", "write element NAME COUNT");
        element.name = words[1];
        for (const PlyElement& other : header_.elements)
            if (other.name == element.name) return wrong(fmt::format("a second element '{}'", element.name));
        header_.elements.push_back(std::move(element));
        return {};
    }

    Result<void> read_property(const std::vector<std::string_view>& words) {
        if (header_.elements.empty()) return wrong("a property before the first element");
        PlyProperty property;
        property.is_list = words.size() > 1 && words[1] == "list";
        if (words.size() != (property.is_list ? 5 : 3))
            return wrong("a property without a type and a name",
                         "write property TYPE NAME or property list TYPE TYPE NAME");
        const std::optional<PlyType> type = type_named(words[words.size() - 2]);
        const std::optional<PlyType> count_type =
            property.is_list ? type_named(words[2]) : property.count_type;
        if (!type || !count_type || !is_integer(*count_type)) return wrong("an unknown type of property");
        property.name = words.back();
        property.type = *type;
        property.count_type = *count_type;
        header_.elements.back().properties.push_back(std::move(property));
        return {};
    }

    std::string_view bytes_;
    const std::string& name_;
    PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

Result<PlyHeader> parse_ply_header(std::string_view bytes, const std::string& name) {
    return HeaderReader(bytes, name).read();
}

}  // namespace sinew
