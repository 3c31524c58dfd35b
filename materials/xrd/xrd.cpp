#include "materials/xrd/xrd.hpp"

#include <array>

#include "materials/base/error.hpp"
#include "materials/xrd/readers.hpp"

namespace ashimpact {

namespace {

struct Reader {
    bool (*recognises)(const TextLines&);
    XrdResult (*read)(const TextLines&);
};

/// Tried in this order: the formats that are recognised most reliably come first.
constexpr std::array readers{
    Reader{xrd::looks_like_json, xrd::read_json},   Reader{xrd::looks_like_bgmn, xrd::read_bgmn},
    Reader{xrd::looks_like_gsas2, xrd::read_gsas2}, Reader{xrd::looks_like_fullprof, xrd::read_fullprof},
    Reader{xrd::looks_like_topas, xrd::read_topas}, Reader{xrd::looks_like_table, xrd::read_table},
};

XrdResult read(std::string_view text) {
    const TextLines file(text, {.content = "an XRD result", .bytes = longest_xrd_file});
    for (const Reader& reader : readers) {
        if (!reader.recognises(file)) continue;
        XrdResult result = reader.read(file);
        if (file.was_latin1()) result.warnings.emplace_back("the file is not UTF-8 and was read as Latin-1");
        return result;
    }
    throw InputError("the format is not known", xrd::known_formats).at(at_line(1));
}

/// The file's name without folders and ending.
std::string stem(std::string_view name) {
    name.remove_prefix(name.find_last_of("/\\") + 1);
    const auto dot = name.rfind('.');
    return std::string(dot == 0 ? name : name.substr(0, dot));
}

}  // namespace

XrdResult read_xrd(std::string_view text, std::string_view name) {
    try {
        XrdResult result = read(text);
        for (XrdSample& sample : result.samples)
            if (sample.name.empty()) sample.name = stem(name);
        return result;
    } catch (const InputError& error) {
        throw error.in_file(std::string(name));
    }
}

}  // namespace ashimpact
