#include "sinew/io/sinew_node.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "sinew/io/sinew_words.h"

namespace sinew {
namespace {

/// Takes the values of one node. The first error stays, and what follows it does no harm.
class NodeReader {
  public:
    explicit NodeReader(std::size_t index) : index_(index) {}

    Result<SinewNode> read(const Json& object) {
        check_keys(object);
        if (error_) return fail(std::move(*error_));
        Json unknown = Json::object();
        for (const auto& [key, value] : object.get_ref<const Json::object_t&>()) {
            key_ = key;
            if (Setter set = setter_of(key))
                (this->*set)(value);
            else
                unknown.get_ref<Json::object_t&>().emplace_back(key, value);
        }
        if (error_) return fail(std::move(*error_));
        if (!unknown.empty()) read_.unknown = unknown.dump();
        return std::move(read_);
    }

  private:
    using Setter = void (NodeReader::*)(const Json&);

    void check_keys(const Json& object) {
        if (!object.is_object()) return complain("a node must be an object", "write {\"id\": 1, ...}");
        const Json* id = find(object, "id");
        id_ = id ? integer_in(*id) : std::nullopt;
        for (const char* key : {"id", "position", "radius"})
            if (!find(object, key)) return complain(fmt::format("the node has no {}", key), "add the key");
    }

    /// About the value of the key that is being read, or else about the node.
    void complain(std::string message, std::string cure) {
        if (error_) return;
        error_ = Error{.message = std::move(message), .cure = std::move(cure), .node = id_};
        error_->path = fmt::format("/nodes/{}{}{}", index_, key_.empty() ? "" : "/", key_);
    }

    double number(const Json& value) {
        if (value.is_number()) return value.get<double>();
        complain(fmt::format("the {} must be a number, not {}", key_, value.type_name()),
                 value.is_string() ? "write it without quotes" : "give a number");
        return 0;
    }
    /// Writes `least` to `most` numbers and returns how many there were.
    std::size_t numbers(const Json& value, std::size_t least, std::size_t most, double* out) {
        if (!value.is_array() || value.size() < least || value.size() > most) {
            const std::string count =
                least == most ? fmt::format("{}", least) : fmt::format("{} or {}", least, most);
            complain(fmt::format("the {} must be an array of {} numbers", key_, count),
                     fmt::format("write \"{}\": [...]", key_));
            return 0;
        }
        for (const Json& entry : value) *out++ = number(entry);
        return value.size();
    }
    std::string text(const Json& value) {
        if (value.is_string()) return value.get<std::string>();
        complain(fmt::format("the {} must be text, not {}", key_, value.type_name()), "write it in quotes");
        return {};
    }
    std::int64_t id(const Json& value) {
        const std::optional<std::int64_t> number = integer_in(value);
        if (!number || *number < 0)
            complain(fmt::format("the {} must be an integer from 0 up, below 2^63", key_),
                     value.is_null() ? "leave the key out for a root" : "number the nodes from 0 up");
        return number.value_or(0);
    }
    template <class Enum, std::size_t n>
    Enum word(const Json& value, const std::array<std::string_view, n>& words) {
        const std::string given = text(value);
        const auto found = std::ranges::find(words, given);
        if (!error_ && found == words.end())
            complain(fmt::format("there is no {} \"{}\"", key_, given),
                     fmt::format("choose one of {}", fmt::join(words, ", ")));
        return error_ ? Enum{} : static_cast<Enum>(found - words.begin());
    }

    // --- keys of a node

    void set_id(const Json& value) { read_.node.id = id(value); }
    void set_parent(const Json& value) { read_.parent_id = id(value); }
    void set_position(const Json& value) { numbers(value, 3, 3, read_.node.position.data()); }
    void set_radius(const Json& value) { read_.node.radius = number(value); }
    void set_name(const Json& value) {
        read_.name = text(value);
        read_.node.given.name = true;
    }
    void set_type(const Json& value) {
        read_.node.type = word<NodeType>(value, node_type_words);
        read_.node.given.type = true;
    }
    void set_section(const Json& value) {
        read_.node.section = word<Section>(value, section_words);
        read_.node.given.section = true;
    }
    void set_scale(const Json& value) {
        read_.node.given.scale_of_three = numbers(value, 2, 3, read_.node.scale.data()) == 3;
        read_.node.given.scale = true;
    }
    void set_size(const Json& value) { numbers(value, 3, 3, read_.node.size.emplace().data()); }
    void set_roll(const Json& value) {
        read_.node.roll = number(value);
        read_.node.given.roll = true;
    }
    void set_rotation(const Json& value) {
        numbers(value, 4, 4, read_.node.rotation.emplace().coeffs().data());
    }
    void set_blend(const Json& value) { read_.node.blend = number(value); }
    void set_joint(const Json& value) {
        read_.node.given.joint = true;
        read_.node.given.joint_in_words = value.is_string();
        if (!value.is_string()) {
            read_.node.joint = number(value);
            return;
        }
        const std::string given = text(value);
        read_.node.joint = given == "sharp" ? infinitely_sharp : 0;
        if (given != "sharp" && given != "smooth")
            complain(fmt::format("there is no joint \"{}\"", given),
                     "say \"smooth\", \"sharp\" or a number from 0 to 10");
    }

    static Setter setter_of(std::string_view key) {
        using N = NodeReader;
        // clang-format off
        static constexpr std::pair<std::string_view, Setter> setters[] = {
            {"id", &N::set_id},           {"parent", &N::set_parent},     {"position", &N::set_position},
            {"radius", &N::set_radius},   {"name", &N::set_name},         {"type", &N::set_type},
            {"section", &N::set_section}, {"scale", &N::set_scale},       {"size", &N::set_size},
            {"roll", &N::set_roll},       {"rotation", &N::set_rotation}, {"joint", &N::set_joint},
            {"blend", &N::set_blend}};
        // clang-format on
        for (const auto& [name, setter] : setters)
            if (name == key) return setter;
        return nullptr;
    }

    std::size_t index_;
    SinewNode read_;
    std::optional<std::int64_t> id_;
    std::string_view key_;
    std::optional<Error> error_;
};

}  // namespace

Result<SinewNode> read_sinew_node(const Json& object, std::size_t index) {
    return NodeReader(index).read(object);
}

}  // namespace sinew
