#include "sinew/io/skeleton_formats.h"

#include "sinew/io/files.h"
#include "sinew/io/formats.h"
#include "sinew/io/gltf_joints.h"
#include "sinew/io/graph_format.h"
#include "sinew/io/sinew_format.h"
#include "sinew/io/swc_format.h"

namespace sinew {
namespace {

Result<ReadSkeleton> parse(std::string_view text, FormatName format, const ReadOptions& options) {
    switch (format) {
        case FormatName::sinew:
            return parse_sinew(text, options);
        case FormatName::graph:
            return parse_graph(text, options);
        case FormatName::swc:
            return parse_swc(text, options);
        case FormatName::gltf:
        case FormatName::glb:
            return parse_gltf(text, options);
        default:
            return fail(ErrorKind::program,
                        "the table of formats names a skeleton reader that does not exist");
    }
}

Result<WrittenSkeleton> print(const Document& document, FormatName format) {
    switch (format) {
        case FormatName::sinew:
            return print_sinew(document);
        case FormatName::graph:
            return print_graph(document);
        case FormatName::swc:
            return print_swc(document);
        default:
            return fail(ErrorKind::program,
                        "the table of formats names a skeleton writer that does not exist");
    }
}

template <class T>
Result<T> named(Result<T> result, const std::string& file) {
    if (!result && result.error().file.empty()) result.error().file = file;
    return result;
}

}  // namespace

Result<ReadSkeleton> read_skeleton(const std::string& path, const ReadOptions& options) {
    const Result<const Format*> format = choose_format(path, options.format, FormatUse::read_skeleton);
    if (!format) return fail(format.error());
    const Result<std::string> text = read_file(path);
    if (!text) return fail(text.error());
    return named(parse(*text, (*format)->id, options), input_name(path));
}

Result<ReadSkeleton> parse_skeleton(std::string_view text, const std::string& name,
                                    const ReadOptions& options) {
    const Result<const Format*> format = choose_format(name, options.format, FormatUse::read_skeleton);
    if (!format) return fail(format.error());
    return named(parse(text, (*format)->id, options), input_name(name));
}

Result<Warnings> write_skeleton(const Document& document, const std::string& path,
                                const std::string& format) {
    Result<WrittenSkeleton> printed = print_skeleton(document, path, format);
    if (!printed) return fail(std::move(printed.error()));
    if (Result<void> written = write_file(path, printed->text); !written)
        return fail(std::move(written.error()));
    return std::move(printed->warnings);
}

Result<WrittenSkeleton> print_skeleton(const Document& document, const std::string& path,
                                       const std::string& format) {
    const Result<const Format*> chosen = choose_format(path, format, FormatUse::write_skeleton);
    if (!chosen) return fail(chosen.error());
    return print(document, (*chosen)->id);
}

}  // namespace sinew
