#include "document/references.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace sinew::modeler {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* names[] = {"side", "front", "above"};
constexpr double most = 1e9;  ///< of a length

Json object_in(const Json& outer, const char* key) {
    const auto found = outer.find(key);
    return found != outer.end() && found->is_object() ? *found : Json::object();
}

Json kept(const Document& document) {
    Json keys = Json::parse(document.extra, nullptr, false);
    return keys.is_object() ? keys : Json::object();
}

double number(const Json& object, const char* key, double otherwise, double least, double greatest) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) return otherwise;
    return std::clamp(found->get<double>(), least, greatest);
}

Reference read(const Json& object) {
    Reference reference;
    const auto file = object.find("file");
    if (file == object.end() || !file->is_string()) return reference;
    reference.file = file->get<std::string>();
    reference.height = number(object, "height", reference.height, 1 / most, most);
    reference.opacity = number(object, "opacity", reference.opacity, 0, 1);
    reference.offset = {number(object, "right", 0, -most, most), number(object, "up", 0, -most, most)};
    return reference;
}

Json written(const Reference& reference) {
    Json object{{"file", reference.file}, {"height", reference.height}, {"opacity", reference.opacity}};
    if (reference.offset[0] != 0) object["right"] = reference.offset[0];
    if (reference.offset[1] != 0) object["up"] = reference.offset[1];
    return object;
}

/// An empty object takes its key with it.
void put(Json& outer, const char* key, Json inner) {
    inner.empty() ? void(outer.erase(key)) : void(outer[key] = std::move(inner));
}

/// True for what lies in the folder or below it, seen from there.
bool is_below(const fs::path& relative) {
    return !relative.empty() && relative.is_relative() && *relative.begin() != "..";
}

template <class Change>
Document with_files(Document document, Change change) {
    References references = references_of(document);
    for (Reference& reference : references)
        if (!reference.file.empty()) reference.file = change(fs::path(reference.file)).string();
    if (references == references_of(document)) return document;
    return with_references(std::move(document), references);
}

}  // namespace

References references_of(const Document& document) {
    References references;
    if (document.extra.empty()) return references;
    const Json all = object_in(object_in(kept(document), "modeler"), "references");
    for (std::size_t axis = 0; axis < references.size(); ++axis)
        references[axis] = read(object_in(all, names[axis]));
    return references;
}

Document with_references(Document document, const References& references) {
    Json keys = kept(document);
    Json ours = object_in(keys, "modeler"), all = Json::object();
    for (std::size_t axis = 0; axis < references.size(); ++axis)
        if (!references[axis].file.empty()) all[names[axis]] = written(references[axis]);
    put(ours, "references", std::move(all));
    put(keys, "modeler", std::move(ours));
    document.extra = keys.empty() ? std::string() : keys.dump();
    return document;
}

Document with_absolute_files(Document document, const std::string& folder) {
    return with_files(std::move(document),
                      [&](const fs::path& file) { return (fs::path(folder) / file).lexically_normal(); });
}

Document with_relative_files(Document document, const std::string& folder) {
    return with_files(std::move(document), [&](const fs::path& file) {
        const fs::path seen = file.lexically_relative(folder);
        return is_below(seen) ? seen : file;
    });
}

}  // namespace sinew::modeler
