#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>

#include "sinew/io/json_text.h"
#include "sinew/io/sinew_format.h"
#include "sinew/io/sinew_node.h"
#include "sinew/io/sinew_words.h"
#include "sinew/skeleton/validate.h"

namespace sinew {
namespace {

constexpr std::int64_t newest_version = 1;

/// Fills a document from the values. The first error stays, and what follows it does no harm.
class DocumentReader {
  public:
    Result<Document> read(const Json& root) {
        read_head(root);
        if (!error_) read_nodes(root);
        if (!error_) read_parents();
        if (!error_) read_links(root);
        if (!error_) read_symmetry(root);
        if (!error_) read_surface(root);
        if (!error_) keep_unknown(root);
        if (error_) return fail(std::move(*error_));
        return std::move(document_);
    }

  private:
    void complain(std::string path, std::string message, std::string cure,
                  std::optional<std::int64_t> node = {}) {
        if (!error_)
            error_ = Error{.message = std::move(message),
                           .cure = std::move(cure),
                           .path = std::move(path),
                           .node = node};
    }

    void read_head(const Json& root) {
        if (!root.is_object())
            return complain("", "this is JSON, but no Sinew document",
                            "the text must be an object: {\"format\": \"sinew\", ...}");
        const Json* format = find(root, "format");
        if (!format || *format != "sinew")
            return complain("/format", "this is JSON, but no Sinew document",
                            "a document says \"format\": \"sinew\"");
        const Json* given = find(root, "version");
        const std::optional<std::int64_t> version = given ? integer_in(*given) : std::nullopt;
        if (!version || *version < 1)
            return complain("/version", "the version must be a number from 1 up", "write \"version\": 1");
        if (*version > newest_version)
            return complain("/version",
                            fmt::format("the document is of version {}, and this program knows version {}",
                                        *version, newest_version),
                            "get a newer Sinew");
        if (const Json* unit = find(root, "unit")) {
            if (!unit->is_string())
                return complain("/unit", "the unit must be text", "write \"m\", \"mm\", \"um\" ...");
            document_.unit = unit->get<std::string>();
            document_.unit_given = true;
        }
    }

    void read_nodes(const Json& root) {
        const Json* nodes = find(root, "nodes");
        if (!nodes || !nodes->is_array())
            return complain("/nodes", "the document has no array of nodes", "write \"nodes\": [...]");
        document_.nodes.reserve(nodes->size());
        parent_ids_.reserve(nodes->size());
        for (const Json& node : *nodes) {
            Result<SinewNode> read = read_sinew_node(node, document_.nodes.size());
            if (!read) {
                error_ = std::move(read.error());
                return;
            }
            add(std::move(*read));
        }
    }

    void add(SinewNode&& read) {
        auto put = [&](std::vector<std::string>& table, std::string&& text) {
            if (text.empty() && table.empty()) return;
            table.resize(document_.nodes.size());
            table.push_back(std::move(text));
        };
        put(document_.names, std::move(read.name));
        put(document_.extras, std::move(read.unknown));
        document_.nodes.push_back(read.node);
        parent_ids_.push_back(read.parent_id);
    }

    /// -1 where there is none.
    std::int32_t index_of(std::int64_t id) const {
        const auto found = std::ranges::lower_bound(by_id_, std::pair(id, std::int32_t{0}));
        return found != by_id_.end() && found->first == id ? found->second : -1;
    }

    void read_parents() {
        by_id_.reserve(document_.nodes.size());
        for (std::int32_t i = 0; i < std::ssize(document_.nodes); ++i)
            by_id_.emplace_back(document_.nodes[i].id, i);
        if (!std::ranges::is_sorted(by_id_)) std::ranges::sort(by_id_);
        for (std::int32_t i = 0; i < std::ssize(document_.nodes); ++i) {
            if (parent_ids_[i] < 0) continue;
            document_.nodes[i].parent = index_of(parent_ids_[i]);
            if (document_.nodes[i].parent < 0)
                return complain(fmt::format("/nodes/{}/parent", i),
                                fmt::format("there is no node {} to be the parent", parent_ids_[i]),
                                "name an existing node, or leave the key out for a root",
                                document_.nodes[i].id);
        }
    }

    void read_links(const Json& root) {
        const Json* links = find(root, "links");
        if (!links) return;
        document_.links_given = true;
        if (!links->is_array())
            return complain("/links", "the links must be an array of pairs", "write \"links\": [[7, 9]]");
        for (const Json& link : *links) {
            const std::string path = fmt::format("/links/{}", document_.links.size());
            if (!link.is_array() || link.size() != 2)
                return complain(path, "a link must be a pair of node ids", "write [7, 9]");
            std::array<std::int32_t, 2>& ends = document_.links.emplace_back();
            for (int end : {0, 1}) {
                const std::optional<std::int64_t> id = integer_in(link[end]);
                ends[end] = id ? index_of(*id) : -1;
                if (ends[end] < 0)
                    return complain(fmt::format("{}/{}", path, end),
                                    id ? fmt::format("there is no node {}", *id) : "this is no node's id",
                                    "name two existing nodes");
            }
        }
    }

    void read_symmetry(const Json& root) {
        const Json* given = find(root, "symmetry");
        if (!given) return;
        const char* cure = "write {\"mirror\": \"x\"} or {\"radial\": {\"axis\": \"z\", \"count\": 8}}";
        const Json* mirror = given->is_object() ? find(*given, "mirror") : nullptr;
        const Json* radial = given->is_object() ? find(*given, "radial") : nullptr;
        if (!mirror == !radial) return complain("/symmetry", "a symmetry is either mirror or radial", cure);
        if (mirror) {
            document_.symmetry.kind = Symmetry::Kind::mirror;
            return read_axis(mirror, "/symmetry/mirror");
        }
        if (!radial->is_object()) return complain("/symmetry/radial", "a radial symmetry is an object", cure);
        document_.symmetry.kind = Symmetry::Kind::radial;
        read_axis(find(*radial, "axis"), "/symmetry/radial/axis");
        const Json* count = find(*radial, "count");
        const std::optional<std::int64_t> images = count ? integer_in(*count) : std::nullopt;
        if (!images || *images < 2 || *images > largest_symmetry_count)
            return complain("/symmetry/radial/count",
                            fmt::format("the count must be an integer from 2 to {}", largest_symmetry_count),
                            cure);
        document_.symmetry.count = static_cast<int>(*images);
    }

    /// A number in a range, where there is one.
    std::optional<double> number_in(const Json& object, const char* key, std::string path, double least,
                                    double most) {
        const Json* given = find(object, key);
        if (!given) return std::nullopt;
        const double value = given->is_number() ? given->get<double>() : -1;
        if (!(value >= least && value <= most)) {
            complain(path + "/" + key, fmt::format("\"{}\" must be a number from {} to {}", key, least, most),
                     "correct it, or leave it out");
            return std::nullopt;
        }
        return value;
    }
    void read_surface(const Json& root) {
        document_.blend = number_in(root, "blend", "", 0, largest_blend);
        const Json* density = find(root, "density");
        if (!density) return;
        if (!density->is_object())
            return complain("/density", "the density must be an object", "write {\"aspect\": 2}");
        document_.density.aspect =
            number_in(*density, "aspect", "/density", least_aspect, largest_length).value_or(0);
        document_.density.edge_length =
            number_in(*density, "edge_length", "/density", std::numeric_limits<double>::min(), largest_length)
                .value_or(0);
    }

    void read_axis(const Json* value, const char* path) {
        const auto found = value && value->is_string()
                               ? std::ranges::find(axis_words, value->get<std::string>())
                               : axis_words.end();
        if (found == axis_words.end())
            return complain(path, "the axis must be \"x\", \"y\" or \"z\"", "name one of them");
        document_.symmetry.axis = static_cast<int>(found - axis_words.begin());
    }

    void keep_unknown(const Json& root) {
        Json unknown =
            without(root, {"format", "version", "unit", "symmetry", "blend", "density", "nodes", "links"});
        if (const Json* symmetry = find(root, "symmetry")) {
            Json inside = without(*symmetry, {"mirror", "radial"});
            if (const Json* radial = find(*symmetry, "radial"))
                if (Json rest = without(*radial, {"axis", "count"}); !rest.empty())
                    inside["radial"] = std::move(rest);
            if (!inside.empty()) unknown["symmetry"] = std::move(inside);
        }
        if (const Json* density = find(root, "density"))
            if (Json rest = without(*density, {"aspect", "edge_length"}); !rest.empty())
                unknown["density"] = std::move(rest);
        if (!unknown.empty()) document_.extra = unknown.dump();
    }

    Document document_;
    std::optional<Error> error_;
    std::vector<std::int64_t> parent_ids_;
    std::vector<std::pair<std::int64_t, std::int32_t>> by_id_;
};

}  // namespace

Result<ReadSkeleton> parse_sinew(std::string_view text, const ReadOptions& options) try {
    Result<Json> json = parse_json(text);
    if (!json) return fail(std::move(json.error()));
    Result<Document> document = DocumentReader().read(*json);
    Error error;
    if (!document) {
        error = std::move(document.error());
    } else {
        Result<void> valid = options.validate ? validate(*document) : Result<void>();
        if (valid) return ReadSkeleton{.document = std::move(*document)};
        error = std::move(valid.error());
    }
    error.line = line_of(text, error.path);
    return fail(std::move(error));
} catch (const std::exception& exception) {  // bad_alloc
    return fail(ErrorKind::program, fmt::format("the document cannot be taken in ({})", exception.what()));
}

}  // namespace sinew
