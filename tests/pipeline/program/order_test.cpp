// SPDX-License-Identifier: GPL-3.0-or-later
// What must change no result: the order of rows, columns, samples, phases, laws, keys and options; units; the
// name of a sample; another sample or law beside it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/embedded.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::Sandbox;

namespace {

/// Names and texts of files.
using Files = std::map<std::string, std::string>;

/// What a document holds, by its path. Elements of lists are known by their texts, so that their order does
/// not count; numbers under one path are sorted. Numbers of rows are left out.
using Content = std::map<std::string, std::vector<double>>;

/// A text without the numbers of rows in it.
std::string known(const std::string& text) {
    return text.substr(0, std::min(text.find(": line"), text.find(", first number")));
}

void add_content(const Json& node, const std::string& path, Content& content) {
    static const std::set<std::string> of_rows{"number", "outliers", "line"};
    if (node.is_object()) {
        for (const auto& [key, value] : node.items())
            if (!of_rows.contains(key)) add_content(value, path + "/" + key, content);
    } else if (node.is_array()) {
        std::map<std::string, int> seen;
        for (const Json& element : node) {
            std::string name;
            for (const auto& [key, value] : element.items())
                if (element.is_object() && value.is_string()) name += known(value.get<std::string>()) + ",";
            if (element.is_structured()) name = fmt::format("[{}{}]", name, seen[name]++);
            add_content(element, path + name, content);
        }
    } else if (node.is_number()) {
        content[path].push_back(node.get<double>());
    } else {
        content[path + " = " + known(node.dump())].push_back(0);
    }
    if (path.empty())
        for (auto& [place, numbers] : content) std::ranges::sort(numbers);
}

/// Requires that everything in @p some is in @p all, to a relative difference.
void check_within(const Content& some, const Content& all, double tolerance) {
    test::Worst worst;
    for (const auto& [path, numbers] : some) {
        const auto found = all.find(path);
        const bool same = found != all.end() && found->second.size() == numbers.size();
        if (!same) worst.see(std::numeric_limits<double>::infinity(), path);
        for (std::size_t i = 0; same && i < numbers.size(); ++i)
            worst.see(test::relative_difference(numbers[i], found->second[i]),
                      fmt::format("{}: {:.17g}, {:.17g}", path, numbers[i], found->second[i]));
    }
    CHECK(worst.count() > 0);
    CHECK_MESSAGE(worst.deviation() <= tolerance, worst.where());
}

void check_same(const Content& one, const Content& other, double tolerance = 0) {
    check_within(one, other, tolerance);
    check_within(other, one, tolerance);
}

/// Another order of so many things, always the same, in which the middle moves too.
std::vector<std::size_t> other_order(std::size_t count) {
    std::size_t stride = std::max<std::size_t>(1, count * 62 / 100);
    while (std::gcd(stride, count) > 1) --stride;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < count; ++i) order.push_back((count - 1 + i * stride) % count);
    return order;
}

template <class List>
List shuffled_list(const List& list) {
    List result;
    for (const std::size_t i : other_order(list.size())) result.push_back(list[i]);
    return result;
}

/// Keys and lists in another order; columns of one length in the same.
Json shuffled(const Json& node) {
    Json result = node;
    if (node.is_object()) {
        std::vector<std::string> keys;
        for (const auto& member : node.items()) keys.push_back(member.key());
        result = Json::object();
        for (const std::string& key : shuffled_list(keys)) result[key] = shuffled(node.at(key));
    } else if (node.is_array()) {
        result = shuffled_list(node);
        for (Json& element : result) element = shuffled(element);
    }
    return result;
}

/// A table with its rows and columns in another order.
std::string shuffled_table(const std::string& text) {
    std::vector<std::string> rows = test::lines_of(text);
    const auto heading = std::ranges::find_if(rows, [](const auto& row) { return !row.starts_with('#'); });
    const std::vector<std::string> below = shuffled_list(std::vector(heading + 1, rows.end()));
    std::ranges::copy(below, heading + 1);
    std::string result;
    for (auto row = rows.begin(); row != rows.end(); ++row) {
        std::vector<std::string> cells{""};
        for (const char letter : *row)
            if (letter == ',' && row >= heading)
                cells.emplace_back();
            else
                cells.back() += letter;
        cells = shuffled_list(cells);
        for (const std::string& cell : cells) result += cell + (&cell == &cells.back() ? "\n" : ",");
    }
    return result;
}

Files shuffled(const Files& files) {
    Files result;
    for (const auto& [name, text] : files)
        result[name] = name.ends_with(".json") ? shuffled(parse_json(text)).dump(1) : shuffled_table(text);
    return result;
}

void write(const Files& files, const Sandbox& sandbox) {
    for (const auto& [name, text] : files) sandbox.write(name, text);
}

/// Everything that `run` finds and prints of a case.
Content run_of(const Files& files) {
    const Sandbox sandbox;
    write(files, sandbox);
    const std::string printed = test::succeeded(sandbox, "run case.json -o out --no-report").out;
    Json all{{"printed", test::lines_of(printed)}};
    for (const auto& [name, text] : sandbox.everything()) {
        if (!name.starts_with("out/") || name == "out/manifest.json") continue;
        const Json artifact = parse_json(text);
        all[name] = {{"result", artifact.at("result")}, {"notes", artifact.at("notes")}};
    }
    CHECK(all.size() == 11);
    Content content;
    add_content(all, {}, content);
    return content;
}

Files files_of(const std::string& folder, std::initializer_list<const char*> names) {
    Files files;
    for (const std::string name : names) files[name] = embedded_file("cases/" + folder + "/" + name).value();
    return files;
}

const std::string impacts =
    "v_in [m/s],v_r [m/s],u(v_in) [m/s],u(v_r) [m/s]\n1.42,0,0.02,0.02\n1.55,0,0.02,0.02\n"
    "1.72,0.12,0.02,0.02\n1.81,0.22,0.03,0.02\n1.95,0.33,0.02,0.02\n1.95,0.31,0.02,0.02\n"
    "2.10,0.44,0.02,0.02\n2.31,0.58,0.02,0.02\n2.52,0.73,0.02,0.03\n2.90,0.93,0.02,0.02\n"
    "3.35,1.20,0.02,0.02\n3.90,1.51,0.02,0.02\n4.63,1.84,0.02,0.02\n4.80,1.2,0.02,0.02\n";

/// Only the first two columns.
std::string without_uncertainties(const std::string& table) {
    std::string result;
    for (const std::string& line : test::lines_of(table))
        result += line.substr(0, line.find(',', line.find(',') + 1)) + "\n";
    return result;
}

/// `init`'s case with a third size, whose phases are uncertain, and with impacts that state no uncertainty.
Json several_sizes() {
    Json document = test::example_case();
    Json third = document["samples"][0];
    third["name"] = "middle";
    third["diameter"] = "96 um";
    third["composition"] = {{"xrd", "sizes.csv"}, {"xrd_sample", "middle"}, {"amorphous", "40 +- 2 %"}};
    third["restitution"] = {{"file", "bare.csv"}};
    third.erase("measured_critical_velocity");
    document["samples"].push_back(third);
    document.erase("camera");
    document = test::under_laws(std::move(document), {"hertz", "dmt", "jkr"});
    return document;
}

Files several_files(const Json& document) {
    Files files = files_of("example", {"ash.csv", "impacts.csv"});
    files["case.json"] = document.dump();
    files["bare.csv"] = without_uncertainties(impacts);
    files["sizes.csv"] =
        "sample,quartz,mullite,hematite,anhydrite\nfine,3(1),91(1),2(1),4(1)\nmiddle,12(1),80(2),3(1),5(1)\n"
        "coarse,20(1),70(2),4(1),6(1)\n";
    return files;
}

constexpr auto contact_in_units =
    "--radius '44 um' --density '2.6 g/cm3' --contact-modulus '90 GPa' --work-of-adhesion '300 mJ/m2'";
constexpr auto contact_in_si = "--radius 44e-6 --density 2600 --contact-modulus 9e10 --work-of-adhesion 0.3";

Content printed_by(const Sandbox& sandbox, const std::string& command) {
    Content content;
    add_content(parse_json(test::succeeded(sandbox, command + " --json").out), {}, content);
    return content;
}

/// A command, and its options in any order.
struct Command {
    const char* name;
    std::vector<std::string> options;
};

const std::vector<std::string> contact_options{"--diameter '88 um'", "--density '2300 kg/m3'",
                                               "--contact-modulus '88 GPa'", "--work-of-adhesion '0.3 J/m2'"};

const Command commands[]{
    {"contact", {}},
    {"impact", {"--law jkr", "--velocity '2 m/s'", "--damping '0.01 kg/s'", "--detachment zero-overlap"}},
    {"critical-velocity", {"--law maugis-dugdale", "--damping '0.01 kg/s'", "--tabor 2"}},
    {"damping", {"--law dmt", "--velocity '2 m/s'", "--restitution 0.3"}},
    {"damping", {"--law jkr", "--impacts impacts.csv"}},
    {"damping", {"--law dmt", "--impacts impacts.csv", "--robust", "--order 3"}},
    {"damping", {"--law hertz", "--impacts impacts.csv", "--bin 3"}},
    {"damping", {"--law brach-dunn", "--impacts bare.csv"}},
    {"damping",
     {"--law jkr", "--impacts bare.csv", "--frame-rate 80000", "--pixel-size '2 um'", "--frames 5"}},
    {"damping", {"--law thornton-ning", "--impacts impacts.csv", "--yield-pressure '3 GPa'"}},
};

const Command commands_on_files[]{
    {"modulus", {"long.csv", "--amorphous-fraction '42 +- 2 %'", "--rule hill"}},
    {"modulus", {"wide.csv", "--amorphous-fraction remainder"}},
    {"modulus",
     {"peaks.csv", "--amorphous-fraction 0.3", "--porosity-law coble-kingery", "--porosity '10 %'"}},
    {"calibrate", {"case.json", "--free density:each"}},
    {"cross-check", {"case.json"}},
};

Files files_for_commands() {
    Files files = files_of("dong2013", {"case.json", "xrd.csv"});
    files["impacts.csv"] = impacts;
    files["bare.csv"] = without_uncertainties(impacts);
    files["long.csv"] =
        "sample,phase,weight %,uncertainty\nb,hematite,2,0.5\nb,quartz,23,1\nb,mullite,75,1\na,mullite,70,2\n"
        "a,quartz,20,1\na,anhydrite,10,1\n";
    files["wide.csv"] = several_files({}).at("sizes.csv");
    files["peaks.csv"] = "phase,intensity,rir\nquartz,753,3.1\nmullite,410,0.7\nhematite,55,2.4\n";
    files["spec.json"] = R"({"impact": {"laws": ["jkr", "dmt", "hertz"], "density": "2600 kg/m3",
        "contact_modulus": "90 GPa", "damping": "0.0141 kg/s"}, "variables": {
        "radius": {"distribution": "log-normal", "median": "44 um", "geometric_standard_deviation": 1.5},
        "work_of_adhesion": {"distribution": "uniform", "from": "0.1 J/m2", "to": "0.5 J/m2"},
        "velocity": {"distribution": "uniform", "from": "0.5 m/s", "to": "5 m/s"}},
        "sampling": {"method": "quasi-random", "samples": 512, "seed": 1},
        "statistics": {"restitution": {}, "contact_time": {}}, "sensitivity": ["restitution", "captured"]})";
    return files;
}

}  // namespace

TEST_CASE("no order of rows, columns, samples, phases, laws or keys changes a run" *
          doctest::skip(test::sanitized)) {
    for (const Files& files :
         {files_of("dong2013", {"case.json", "xrd.csv"}), several_files(several_sizes())})
        check_same(run_of(files), run_of(shuffled(files)));
}

TEST_CASE("another sample or law changes no result of those beside it; a name changes none either" *
          doctest::skip(test::sanitized)) {
    const Json document = several_sizes();
    Json more = document;
    Json twin = document["samples"][0];
    twin["name"] = "twin";
    more["samples"].insert(more["samples"].begin(), twin);
    more["laws"] = {"sjkr", "jkr", "dmt", "hertz", "brach-dunn"};
    more["particle"] = {{"cohesion_energy_density", "100 MJ/m3"}};
    Content some;  // of each sample, but for the choice between laws, and the list of them
    Content of_twin;
    for (const auto& [path, numbers] : run_of(several_files(document))) {
        const auto sample = path.find("/samples[");
        if (sample == std::string::npos || path.find("/reported") != std::string::npos ||
            path.find("/laws") != std::string::npos || path.find("/parameters") != std::string::npos)
            continue;
        some[path] = numbers;
        if (path.find("/samples[fine,") != sample) continue;
        if (!path.ends_with("/name = \"fine\""))
            of_twin[path.substr(0, sample) + "/samples[twin," + path.substr(sample + 14)] = numbers;
    }
    const Content all = run_of(several_files(more));
    check_within(some, all, 0);
    check_within(of_twin, all, 0);
}

TEST_CASE("no order of options, rows, phases or keys changes what the other commands print" *
          doctest::skip(test::sanitized)) {
    const Files files = files_for_commands();
    const Sandbox sandbox;
    const Sandbox other;
    write(files, sandbox);
    write(shuffled(files), other);
    const auto check = [&](const std::string& name, const std::vector<std::string>& options) {
        const auto with = [&](const std::vector<std::string>& list) {
            return fmt::format("{} {}", name, fmt::join(list, " "));
        };
        CAPTURE(with(options));
        check_same(printed_by(sandbox, with(options)), printed_by(other, with(shuffled_list(options))));
    };
    for (auto [name, options] : commands) {
        options.insert(options.begin(), contact_options.begin(), contact_options.end());
        check(name, options);
    }
    for (const auto& [name, options] : commands_on_files) check(name, options);
    for (const Sandbox* each : {&sandbox, &other}) test::succeeded(*each, "sweep spec.json -o s.json");
    Content one;
    Content two;
    add_content(sandbox.json("s.json").at("result"), {}, one);
    add_content(other.json("s.json").at("result"), {}, two);
    check_same(one, two);
}

// Of impacts in a table, the numbers are such that they convert without rounding: the posterior's search of a
// curve makes 1e-8 of a last digit.
TEST_CASE("units change no result") {
    const Sandbox sandbox;
    sandbox.write("m.csv", without_uncertainties(impacts));
    sandbox.write("mm.csv",
                  "v_in [mm/s],v_r [cm/s]\n1420,0\n1550,0\n1720,12\n1810,22\n1950,33\n1950,31\n"
                  "2100,44\n2310,58\n2520,73\n2900,93\n3350,120\n3900,151\n4630,184\n4800,120\n");
    struct InUnits {
        const char* command;
        const char* units;
        const char* si;
    };
    for (const auto& [command, units, si] :
         {InUnits{"contact", "", ""},
          {"impact --law dmt", "--velocity '200 cm/s' --damping '5 g/s'", "--velocity 2 --damping 0.005"},
          {"impact --law jkr", "--velocity '7.2 km/h' --damping '5 mN s/m'", "--velocity 2 --damping 0.005"},
          {"critical-velocity --law jkr", "--damping '14.1 g/s'", "--damping 0.0141"},
          {"damping --law brach-dunn", "--velocity '2000 mm/s' --restitution '20 %'",
           "--velocity 2 --restitution 0.2"},
          {"damping --law dmt", "--impacts mm.csv", "--impacts m.csv"}}) {
        CAPTURE(std::string(command));
        check_same(printed_by(sandbox, fmt::format("{} {} {}", command, contact_in_units, units)),
                   printed_by(sandbox, fmt::format("{} {} {}", command, contact_in_si, si)), 1e-12);
    }
}
