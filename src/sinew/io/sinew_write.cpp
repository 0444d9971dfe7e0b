#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <utility>

#include "sinew/io/json_text.h"
#include "sinew/io/sinew_format.h"
#include "sinew/io/sinew_words.h"

namespace sinew {
namespace {

std::string json_string(std::string_view text) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The pairs of an object without its braces, each with a comma before it.
void append_pairs(std::string& out, const Json& object) {
    for (const auto& [key, value] : object.get_ref<const Json::object_t&>())
        out += fmt::format(", {}: {}", json_string(key), value.dump());
}

/// An object that was kept as text; empty where there is none.
Json kept(const std::string& text) {
    Json object = text.empty() ? Json::object() : parse_json(text).value_or(Json());
    return object.is_object() ? object : Json::object();
}

Json inner(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_object() ? *found : Json::object();
}

class Writer {
  public:
    explicit Writer(const Document& document) : document_(document) {}

    Result<WrittenSkeleton> write() {
        const Json unknown = kept(document_.extra);
        out_.reserve(64 + 96 * document_.nodes.size());
        out_ += "{\n  \"format\": \"sinew\",\n  \"version\": 1";
        if (document_.unit_given || !document_.unit.empty()) put_key("unit", json_string(document_.unit));
        if (document_.symmetry.kind != Symmetry::Kind::none)
            put_key("symmetry", symmetry(inner(unknown, "symmetry")));
        if (document_.blend) put_key("blend", fmt::format("{}", *document_.blend));
        if (const Json density = this->density(inner(unknown, "density")); !density.empty())
            put_key("density", density.dump());
        for (const auto& [key, value] : unknown.get_ref<const Json::object_t&>())
            if (key != "symmetry" && key != "density") put_key(key, value.dump());
        put_nodes();
        if (document_.links_given || !document_.links.empty()) put_links();
        out_ += "\n}\n";
        if (error_) return fail(std::move(*error_));
        return WrittenSkeleton{.text = std::move(out_)};
    }

  private:
    void put_key(std::string_view key, std::string_view value) {
        out_ += fmt::format(",\n  {}: {}", json_string(key), value);
    }

    Json density(Json unknown) const {
        if (document_.density.aspect > 0) unknown["aspect"] = document_.density.aspect;
        if (document_.density.edge_length > 0) unknown["edge_length"] = document_.density.edge_length;
        return unknown;
    }

    std::string symmetry(const Json& unknown) const {
        const std::string_view axis = axis_words[document_.symmetry.axis];
        std::string text;
        if (document_.symmetry.kind == Symmetry::Kind::mirror) {
            text = fmt::format("{{\"mirror\": \"{}\"", axis);
        } else {
            text = fmt::format("{{\"radial\": {{\"axis\": \"{}\", \"count\": {}", axis,
                               document_.symmetry.count);
            append_pairs(text, inner(unknown, "radial"));
            text += "}";
        }
        for (const auto& [key, value] : unknown.get_ref<const Json::object_t&>())
            if (key != "radial") text += fmt::format(", {}: {}", json_string(key), value.dump());
        return text + "}";
    }

    void put_nodes() {
        out_ += ",\n  \"nodes\": [";
        for (std::size_t i = 0; i < document_.nodes.size(); ++i) {
            out_ += i == 0 ? "\n    " : ",\n    ";
            put_node(i);
        }
        out_ += document_.nodes.empty() ? "]" : "\n  ]";
    }

    void put_node(std::size_t i) {
        const Node& node = document_.nodes[i];
        fmt::format_to(std::back_inserter(out_), "{{\"id\": {}", node.id);
        if (node.parent >= 0)
            fmt::format_to(std::back_inserter(out_), ", \"parent\": {}", id_of(node.parent, i));
        put("position", {node.position.x(), node.position.y(), node.position.z()}, i);
        put("radius", node.radius, i);
        if (!document_.names.empty() && (node.given.name || !document_.names[i].empty()))
            put("name", json_string(document_.names[i]));
        else if (node.given.name)
            put("name", "\"\"");
        if (node.given.type || node.type != NodeType::sphere)
            put("type", json_string(node_type_words[static_cast<int>(node.type)]));
        put_shape(node, i);
        if (!document_.extras.empty() && !document_.extras[i].empty())
            append_pairs(out_, kept(document_.extras[i]));
        out_ += "}";
    }

    void put_shape(const Node& node, std::size_t i) {
        if (node.given.section || node.section != Section::round)
            put("section", json_string(section_words[static_cast<int>(node.section)]));
        const auto& [a, b, c] = node.scale;
        if (node.given.scale_of_three || c != 1)
            put("scale", {a, b, c}, i);
        else if (node.given.scale || a != 1 || b != 1)
            put("scale", {a, b}, i);
        if (node.size) put("size", {node.size->x(), node.size->y(), node.size->z()}, i);
        if (node.given.roll || node.roll != 0) put("roll", node.roll, i);
        if (node.rotation)
            put("rotation", {node.rotation->x(), node.rotation->y(), node.rotation->z(), node.rotation->w()},
                i);
        if (node.blend) put("blend", *node.blend, i);
        if (std::isinf(node.joint) && node.joint > 0)
            put("joint", "\"sharp\"");
        else if (node.joint == 0 && node.given.joint_in_words)
            put("joint", "\"smooth\"");
        else if (node.given.joint || node.joint != 0)
            put("joint", node.joint, i);
    }

    void put_links() {
        out_ += ",\n  \"links\": [";
        for (std::size_t k = 0; k < document_.links.size(); ++k) {
            const auto& [a, b] = document_.links[k];
            const std::string_view separator = k == 0 ? "" : k % 8 == 0 ? ",\n    " : ", ";
            fmt::format_to(std::back_inserter(out_), "{}[{}, {}]", separator, id_of(a, k), id_of(b, k));
        }
        out_ += "]";
    }

    void put(std::string_view key, std::string_view json) {
        fmt::format_to(std::back_inserter(out_), ", \"{}\": {}", key, json);
    }
    void put(std::string_view key, double number, std::size_t node) {
        fmt::format_to(std::back_inserter(out_), ", \"{}\": ", key);
        put_number(key, number, node);
    }
    void put(std::string_view key, std::initializer_list<double> numbers, std::size_t node) {
        fmt::format_to(std::back_inserter(out_), ", \"{}\": ", key);
        const char* separator = "[";
        for (double number : numbers) {
            out_ += std::exchange(separator, ", ");
            put_number(key, number, node);
        }
        out_ += "]";
    }
    /// The shortest digits that read back as the same number.
    void put_number(std::string_view key, double number, std::size_t i) {
        if (!std::isfinite(number))
            complain(fmt::format("the {} of node {} is not finite, which JSON cannot say", key,
                                 document_.nodes[i].id));
        if (number == 0 && std::signbit(number))
            out_ += "-0.0";  // "-0" would be read as the integer 0
        else
            fmt::format_to(std::back_inserter(out_), "{}", number);
    }

    std::int64_t id_of(std::int32_t node, std::size_t from) {
        if (node >= 0 && node < std::ssize(document_.nodes)) return document_.nodes[node].id;
        complain(fmt::format("a parent or link (number {}) names a node that does not exist", from));
        return 0;
    }
    void complain(std::string message) {
        if (!error_)
            error_ = Error{.message = std::move(message), .cure = "correct the document before saving it"};
    }

    const Document& document_;
    std::string out_;
    std::optional<Error> error_;
};

}  // namespace

Result<WrittenSkeleton> print_sinew(const Document& document) { return Writer(document).write(); }

}  // namespace sinew
