// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <ostream>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/document.hpp"
#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/contact/damping_choice.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/export/folder.hpp"
#include "pipeline/present/export/laboratory.hpp"
#include "pipeline/present/export/run_subject.hpp"
#include "pipeline/present/export/subject.hpp"
#include "pipeline/present/text/layout.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

namespace {

constexpr auto mark_of_export = "expected.json";  // every exported folder has one

/// The subject of the options of an impact.
ExportSubject subject_of_options(const CommandOptions& options) {
    const ContactChoice choice = read_contact(options);
    const DampingChoice damping_choice = read_damping_choice(options, choice.contact);
    const Damping& damping = damping_choice.damping;
    const double diameter = 2 * choice.sphere.radius;
    const double density = sphere_density(choice.sphere.radius, choice.sphere.mass);
    ExportSubject subject{.law = choice.law,
                          .detachment = choice.detachment,
                          .damping_law = damping.law,
                          .sizes = {{.diameter = diameter,
                                     .contact = choice.contact,
                                     .density = density,
                                     .damping = {{{0, damping.coefficient}}}}},
                          .from_diameter = diameter,
                          .to_diameter = diameter};
    const std::string sphere = options.has("--mass")
                                   ? "mass " + readable(choice.sphere.mass, "kg") + ", which is a density of"
                                   : "density";
    subject.origins = {fmt::format("radius of the sphere {}, {} {}, from the command line",
                                   readable(choice.sphere.radius, "m"), sphere, readable(density, "kg/m3")),
                       fmt::format("E* = {}, contact modulus of {} together, from the command line",
                                   readable(choice.contact.contact_modulus, "Pa"),
                                   choice.partner ? "both spheres" : "particle and wall"),
                       fmt::format("w = {}, work of adhesion of the pair of surfaces (not a surface energy), "
                                   "from the command line{}",
                                   readable(choice.contact.work_of_adhesion, "J/m2"),
                                   options.has("--roughness") ? ", lowered by --roughness" : "")};
    if (damping_choice.requested) {
        subject.origins.push_back(requested_words(*damping_choice.requested, damping));
        subject.velocity = damping_choice.requested->velocity;  // where the user compares first
    }
    if (choice.partner) subject.partner = {choice.partner->radius, choice.partner->mass};
    if (damping.coefficient == 0 && is_damped(damping, choice.contact.parameters))
        throw InputError("is 0 where another coefficient of the damping acts", "above 0").at("--damping");
    for (const LawParameter& parameter : choice.law.parameters())
        if (choice.contact.parameters.has(parameter))
            subject.origins.push_back(
                fmt::format("{}: {}, from the command line", parameter.description,
                            readable(choice.contact.parameters[parameter], si_unit(parameter.dimension))));
    return subject;
}

/// What belongs to one size alone: a folder takes w and the law's parameters for every size.
void require_same_at_every_size(const CommandOptions& options, const ExportSubject& subject) {
    if (!subject.goes_beyond_sizes()) return;
    if (subject.reference().contact.parameters.has(stated_tabor) && subject.law.takes(stated_tabor))
        throw InputError("goes with the size, and several sizes are asked for",
                         "--cohesion-range or --cohesive-stress, which every size shares")
            .at("--tabor");
    if (options.has("--roughness"))
        throw InputError("lowers w by a share that goes with the size, and several sizes are asked for",
                         "one size, or the w of rough surfaces by --work-of-adhesion")
            .at("--roughness");
}

/// How the coefficient of a damping goes with the size of Hertz spheres of one material that rebound alike.
double exponent_of_same_restitution(const ExportSubject& subject) {
    const auto unit = [&](double size) {
        const ContactPair hertz{.mass = size * size * size,
                                .effective_radius = size,
                                .contact_modulus = 1,
                                .work_of_adhesion = 0};
        return Scale::of(hertz, 1.0).damping_unit(subject.damping_law);
    };
    return std::round(std::log2(unit(2) / unit(1)));
}

/// A range given by the user.
void read_ranges(const CommandOptions& options, ExportSubject& subject) {
    if (options.has("--velocity")) subject.velocity = options.positive("--velocity", Dimension::velocity);
    if (options.has("--from-diameter"))
        subject.from_diameter = options.positive("--from-diameter", Dimension::length);
    if (options.has("--to-diameter"))
        subject.to_diameter = options.positive("--to-diameter", Dimension::length);
    if (subject.from_diameter > subject.to_diameter)
        throw InputError(
            fmt::format("the range goes from {} down to {}", readable(subject.from_diameter, "m"),
                        readable(subject.to_diameter, "m")),
            "a range that rises")
            .at("--from-diameter, --to-diameter");
    require_same_at_every_size(options, subject);
    const bool needs_exponent = subject.goes_beyond_sizes() && !subject.is_undamped();
    if (needs_exponent && !options.has("--damping-exponent"))
        throw InputError(
            subject.sizes.size() == 1
                ? "several sizes are asked for, but not how the damping goes with the size"
                : "sizes beyond the measured ones are asked for, but not how the damping goes on",
            fmt::format("0 for the same damping at every size, {} for the same e of Hertz spheres, ...",
                        exponent_of_same_restitution(subject)))
            .at("--damping-exponent");
    if (options.has("--damping-exponent")) {
        if (!needs_exponent)
            warn_idle("--damping-exponent", subject.is_undamped() ? "there is no damping"
                                            : subject.one_size()  ? "there is one size"
                                                                  : "all sizes lie between measured ones");
        subject.exponent = options.number("--damping-exponent", Dimension::fraction);
        if (std::abs(subject.exponent) > 10)
            throw InputError(
                "is " + shortest(subject.exponent),
                fmt::format("-10 to 10; {} keeps e of Hertz spheres", exponent_of_same_restitution(subject)))
                .at("--damping-exponent");
    }
    if (options.has("--to-velocity")) {
        subject.to_velocity = options.positive("--to-velocity", Dimension::velocity);
    }
    if (options.has("--velocity") && subject.to_velocity && *subject.velocity > *subject.to_velocity)
        throw InputError("lies beyond --to-velocity", "up to " + readable(*subject.to_velocity, "m/s"))
            .at("--velocity");
}

/// What one damping at every velocity does to the impacts of a sample: e there, and v_c beside the run's.
std::string one_damping_line(const ExportSubject& followed, const ExportSubject& constant,
                             const Laboratory& laboratory, double velocity) {
    const auto text = [](const std::optional<double>& v) { return v ? readable(*v, "m/s") : "not finite"; };
    const auto critical = threshold_at(followed, laboratory.diameter).value;
    const DampingCurve& damping =
        std::ranges::find(followed.sizes, laboratory.diameter, &AshSize::diameter)->damping;
    const auto fastest = critical && damping.depends_on_velocity()
                             ? std::optional(velocity_at_place(damping.nodes.back().t, *critical))
                             : std::nullopt;
    std::string measured;
    if (fastest && velocity > *fastest)
        measured = fmt::format("no impact was faster than {}; the damping is that there", text(fastest));
    else if (!laboratory.impacts.empty() && velocity < laboratory.impacts.front().velocity)
        measured = fmt::format("no impact was slower than {}; {}", text(laboratory.impacts.front().velocity),
                               critical && velocity <= *critical ? "the damping is the critical one"
                                                                 : "the damping is that of the run's curve");
    else
        measured = "e is the measured one there";
    return fmt::format("damping of {}: that of {} at every velocity: {}. v_c is {}, that of the run {}",
                       laboratory.sample, text(velocity), measured,
                       text(threshold_at(constant, laboratory.diameter).value), text(critical));
}

/// The subject with the damping of one velocity, and a line on that for each sample.
ExportSubject with_one_damping(const ExportSubject& subject, double velocity) {
    ExportSubject constant = with_damping_at(subject, velocity);
    constant.dampings.clear();
    for (const Laboratory& laboratory : subject.laboratory)
        constant.dampings.push_back(one_damping_line(subject, constant, laboratory, velocity));
    return constant;
}

ExportSubject subject_of(const CommandOptions& options, const ExportCode& code) {
    if (!options.has("run")) {
        if (options.has("--sample"))
            throw InputError("there is no run", "the folder of a run before it").at("--sample");
        if (options.has("--follow-velocity"))
            throw InputError("there is no run whose damping follows the velocity",
                             "the folder of a run before it")
                .at("--follow-velocity");
        if (!options.has("--law"))
            throw InputError("neither a run nor an impact is given",
                             "RUN_DIR --sample S, or --law, --radius and the other options of an impact")
                .at("export " + options["code"]);
        return subject_of_options(options);
    }
    refuse_contact_options(options);
    if (options.has("--follow-velocity") && options.has("--at"))
        throw InputError("one damping and one that follows are asked for", "one of the two")
            .at("--follow-velocity, --at");
    if (options.has("--follow-velocity")) warn_idle("--follow-velocity", "the damping of a run does so");
    ExportSubject subject = subject_of_run(
        {.folder = options["run"], .samples = options.list("--sample"), .law = options["--law"]});
    for (const std::string& doubt : subject.doubts) spdlog::warn("warning: {}", doubt);
    if (!code.takes_samples && subject.sizes.size() > 1)
        throw InputError(
            fmt::format("the run has {} samples, and a folder for {} takes one E*, w and density",
                        subject.sizes.size(), code.name),
            "one of them by --sample; table, openfoam and fluent take several")
            .at("--sample");
    if (options.has("--at")) {
        ExportSubject constant = with_one_damping(subject, options.positive("--at", Dimension::velocity));
        for (const std::string& line : constant.dampings) spdlog::warn("warning: --at: {}", line);
        return constant;
    }
    if (subject.partner && !code.pairs_follow && subject.depends_on_velocity()) {
        const double critical = threshold_at(subject, subject.from_diameter).value.value_or(0);
        spdlog::warn(
            "warning: two spheres have one damping at every velocity in {}: that of v_c = {}, so that e is "
            "too "
            "small above; --at V takes the damping measured at V",
            code.name, readable(critical, "m/s"));
        return with_one_damping(subject, critical);
    }
    return subject;
}

/// Refuses to write over files that no export left there, and among those for another code.
void require_free(const std::filesystem::path& folder, const ExportFolder& files, std::string_view code) {
    require_writable_folder(folder);
    if (const auto mark = folder / mark_of_export; std::filesystem::exists(mark)) {
        const Json earlier = Json::parse(read_file(mark), nullptr, false);
        if (earlier.is_object() && earlier.value("code", code) == code) return;
        throw InputError("is of an export for another code", "an empty folder; -o")
            .at(FileName{mark.string()});
    }
    for (const ExportFile& file : files)
        if (std::filesystem::exists(folder / file.name))
            throw InputError("is there already, and not from an export", "an empty folder; -o")
                .at(FileName{(folder / file.name).string()});
}

}  // namespace

void run_export_command(const CommandOptions& options, const TableImage& image, std::ostream& out) {
    const ExportCode& code = export_code(options["code"]);
    ExportSubject subject = subject_of(options, code);
    read_ranges(options, subject);
    if (options.has("--friction")) {
        if (subject.partner)
            throw InputError("two spheres have no friction in an export", "a wall").at("--friction");
        subject.friction = options.number("--friction", Dimension::fraction);
        at_place("--friction",
                 [&] { require_not_negative("friction", subject.friction, Dimension::fraction); });
    }
    if (options.has("--soften")) {
        if (!code.no_contact.empty())
            throw InputError(fmt::format("{}: {}", code.name, code.no_contact),
                             "lammps, liggghts, yade, table")
                .at("--soften");
        subject = softened(std::move(subject), options.number("--soften", Dimension::fraction));
        require_small_overlaps(subject);
    }
    ExportFolder files = code.folder(subject, image);
    for (ExportFile& file : files)
        if (file.name == "README.md" && !subject.edits.empty())
            file.content += fmt::format("\n## Edited\n\n{}.\n", fmt::join(subject.edits, ".\n"));
    require_inside_model(subject);
    // A run has said before which of its laws suits the contacts.
    const Severity least = options.has("run") ? Severity::remark : Severity::background;
    for (const std::string& remark : regime_remarks(subject, least)) spdlog::warn("warning: {}", remark);
    const std::filesystem::path folder(options["--output"]);
    require_free(folder, files, code.name);
    std::vector<FileContent> contents;
    contents.reserve(files.size());
    for (const ExportFile& file : files) contents.push_back({folder / file.name, file.content});
    write_files(contents);
    for (const FileContent& each : contents) out << each.path.string() << '\n';
    std::string script = (folder / code.script).string();
    if (script.starts_with('-')) script.insert(0, "./");
    out << wrapped(laboratory_lines(subject), output_width(), 2)
        << "README.md has the instructions. To run and compare:\n  "
        << (code.script.ends_with(".py") ? "python3 " : "sh ") << shell_word(script) << '\n';
}

void add_export(const CommandLine& line, const CommandBody& body) {
    Command command = line.add(
        "export", "Runnable inputs for DEM and CFD codes",
        "ashimpact export lammps results --sample \"88 um\" --law brach-dunn -o ash-in-lammps\n"
        "  ashimpact export openfoam results --law jkr -o ash-in-openfoam\n"
        "  ashimpact export openfoam --law dmt --radius \"5 um\" --density \"2300 kg/m3\" --contact-modulus "
        "\"60 GPa\" \\\n    --work-of-adhesion \"0.2 J/m2\" --damping \"1e-5 kg/s\" --from-diameter \"1 um\" "
        "--to-diameter \"50 um\" \\\n    --damping-exponent 2 -o ash-in-openfoam\n"
        "The folder holds inputs, a README, the assumptions, expected.json and a script that compares.",
        body);
    std::vector<std::string> codes;
    for (const ExportCode& code : export_codes()) codes.emplace_back(code.name);
    command.add("code", "CODE", joined(codes))->required();
    command.add("run", "RUN_DIR", "folder of a run; else give the options of an impact");
    command
        .add_list("--sample", "NAME",
                  "of the run; may be given several times for openfoam, fluent, table; default: all")
        ->allow_extra_args(false);
    command.add_flag("--follow-velocity", "of a run: damping along the measured e(v_in), the default");
    command.add_contact_options(false);
    command.add_damping_option();
    command.add("--velocity", "Q", "one more impact to check; default: that of --at");
    command.add("--friction", "MU",
                "coefficient of Coulomb friction on a wall; default: that of the run's case, else none");
    command.add("--from-diameter", "Q", "smallest size; default: that of the sphere or samples");
    command.add("--to-diameter", "Q", "largest size; default: that of the sphere or samples");
    command.add("--to-velocity", "Q", "largest velocity; default: 10 v_c, at least 10 m/s");
    command.add(
        "--damping-exponent", "N",
        "for sizes beyond the known ones: damping goes with (diameter/the nearest known one)^N; 0: the "
        "same for all");
    command.add(
        "--soften", "S",
        "divide E* by S > 1 and scale what goes with it: contacts S^0.4 times longer, the same e and v_c; "
        "for lammps, liggghts, yade, table");
    command.add("-o,--output", "DIR", "folder to write")->required();
}

}  // namespace ashimpact
