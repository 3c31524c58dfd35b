// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <doctest/doctest.h>
#include <fenv.h>  // NOLINT(modernize-deprecated-headers): feenableexcept is no part of <cfenv>
#include <xmmintrin.h>

#include "interface/include/ashimpact.h"
#include "solver/batch/batch.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "tests/support/contact_cases.hpp"

using namespace ashimpact;

namespace {

constexpr std::array<ashimpact_parameter, 5> constants{{{"density", 2160.0},
                                                        {"contact_modulus", 60e9},
                                                        {"work_of_adhesion", 0.3},
                                                        {"damping", 2e-6},
                                                        {"yield_pressure", 3e9}}};

/// A handle that closes itself.
class Handle {
  public:
    explicit Handle(const char* law, const char* detachment = nullptr, const char* damping_law = nullptr,
                    std::size_t count = constants.size()) {
        std::vector<ashimpact_parameter> all(constants.begin(), constants.begin() + static_cast<long>(count));
        const auto damping = damping_law == nullptr ? DampingLaw::constant : named<DampingLaw>(damping_law);
        for (const auto& [name, value] : typical_parameters(parameters_of(Law::named(law), damping)))
            all.push_back({name.data(), value});
        ashimpact_error error;
        REQUIRE_MESSAGE(ashimpact_open(law, detachment, damping_law, all.data(), all.size(), &model_,
                                       &error) == ASHIMPACT_OK,
                        error.message);
    }
    ~Handle() { ashimpact_close(model_); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    Handle(Handle&&) = delete;
    Handle& operator=(Handle&&) = delete;
    [[nodiscard]] const ashimpact_model* get() const { return model_; }

  private:
    ashimpact_model* model_ = nullptr;
};

struct Spheres {
    Eigen::ArrayXd diameter;
    Eigen::ArrayXd velocity;

    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(diameter.size()); }
    [[nodiscard]] Eigen::ArrayXd mass() const {
        return 2160.0 * std::numbers::pi / 6.0 * diameter * diameter * diameter;
    }
    [[nodiscard]] Eigen::ArrayXd radius() const { return diameter / 2.0; }
};

Spheres spheres(Eigen::Index count) {
    const Eigen::ArrayXd i = Eigen::ArrayXd::LinSpaced(count, 0.0, 1.0);
    return {1e-6 * (4.6 * i).exp(), 0.05 * (5.0 * (7.0 * i).sin().abs()).exp()};
}

std::vector<double> restitutions(const Handle& handle, const Spheres& s) {
    std::vector<double> found(s.size());
    REQUIRE(ashimpact_restitutions(handle.get(), s.size(), s.diameter.data(), s.velocity.data(), found.data(),
                                   nullptr) == ASHIMPACT_OK);
    return found;
}

bool same_bits(const std::vector<double>& ours, const Eigen::ArrayXd& theirs) {
    REQUIRE(static_cast<Eigen::Index>(ours.size()) == theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const double other = theirs[static_cast<Eigen::Index>(i)];
        if (std::isnan(ours[i]) && std::isnan(other)) continue;
        if (std::bit_cast<std::uint64_t>(ours[i]) != std::bit_cast<std::uint64_t>(other)) return false;
    }
    return true;
}

ContactColumns contact_of(const Eigen::ArrayXd& mass, const Eigen::ArrayXd& radius) {
    static const Eigen::ArrayXd modulus = Eigen::ArrayXd::Constant(1, 60e9);
    static const Eigen::ArrayXd adhesion = Eigen::ArrayXd::Constant(1, 0.3);
    static const Eigen::ArrayXd yield_pressure = Eigen::ArrayXd::Constant(1, 3e9);
    return {mass, radius, modulus, adhesion, yield_pressure};
}

}  // namespace

TEST_CASE("C interface: the bits of the batch solver, every law, detachment and damping law") {
    for (const test::ContactCase& c : test::elastic_cases()) {
        CAPTURE(test::name_of(c));
        const bool slow =
            c.law == Law::of<ThorntonNing>() || !c.law.parameters().empty() || !has_one_number(c.damping_law);
        const Handle handle(std::string(c.law.name()).c_str(), std::string(name_of(c.detachment)).c_str(),
                            std::string(name_of(c.damping_law)).c_str());
        const Spheres s = spheres(slow ? 20 : 3000);
        const Eigen::ArrayXd mass = s.mass();
        const Eigen::ArrayXd radius = s.radius();
        const Eigen::ArrayXd damping = Eigen::ArrayXd::Constant(1, 2e-6);
        const ParameterValues<double> own = typical_parameters(parameters_of(c.law, c.damping_law));
        ContactColumns contact = contact_of(mass, radius);
        contact.parameters = single_columns(own);
        const ImpactBatchResult expected =
            solve_impacts({c.law, c.detachment, c.damping_law, contact, damping, s.velocity},
                          {.turning_point = false, .method = method_of_many(c.law, c.damping_law)});
        CHECK(ashimpact_method(handle.get()) == name_of(method_of_many(c.law, c.damping_law)));
        std::vector<double> restitution = restitutions(handle, s);
        CHECK(same_bits(restitution, expected.restitution));

        const CriticalVelocityBatchResult critical = critical_velocities(
            {c.law, c.detachment, c.damping_law, contact, damping}, 1, method_of_many_velocities(c.law, 1));
        std::vector<double> velocity(s.size());
        REQUIRE(ashimpact_critical_velocities(handle.get(), s.size(), s.diameter.data(), velocity.data(),
                                              nullptr) == ASHIMPACT_OK);
        Eigen::ArrayXd with_ends = critical.value;
        for (Eigen::Index i = 0; i < with_ends.size(); ++i) {
            if (critical.verdict[i] == CaptureVerdict::never_captured) with_ends[i] = 0.0;
            if (critical.verdict[i] == CaptureVerdict::always_captured) with_ends[i] = HUGE_VAL;
        }
        CHECK(same_bits(velocity, with_ends));

        // One by one, the same bits.
        for (std::size_t i = 0; i < s.size(); i += 7) {
            const auto place = static_cast<Eigen::Index>(i);
            REQUIRE(ashimpact_restitution(handle.get(), s.diameter[place], s.velocity[place], &restitution[i],
                                          nullptr) == ASHIMPACT_OK);
            REQUIRE(ashimpact_critical_velocity(handle.get(), s.diameter[place], &velocity[i], nullptr) ==
                    ASHIMPACT_OK);
        }
        CHECK(same_bits(restitution, expected.restitution));
        CHECK(same_bits(velocity, with_ends));
    }
}

TEST_CASE("C interface: times, overlaps and dampings by columns, with strides and masses of one's own") {
    const Handle handle("jkr", nullptr, nullptr, 4);
    const Spheres s = spheres(2100);
    const Eigen::ArrayXd mass = s.mass();
    const Eigen::ArrayXd radius = s.radius();
    Eigen::ArrayXXd interleaved(2, mass.size());
    interleaved.row(0) = mass;
    interleaved.row(1) = radius;
    const ashimpact_column columns[] = {{"mass", interleaved.data(), 2},
                                        {"effective_radius", interleaved.data() + 1, 2},
                                        {"velocity", s.velocity.data(), 1}};
    std::vector<double> restitution(s.size());
    std::vector<double> time(s.size());
    std::vector<double> overlap(s.size());
    const ashimpact_output outputs[] = {{"maximum_overlap", overlap.data()},
                                        {"approach_time", time.data()},
                                        {"restitution", restitution.data()}};
    REQUIRE(ashimpact_solve_impacts(handle.get(), s.size(), columns, 3, outputs, 3, nullptr) == ASHIMPACT_OK);
    const Eigen::ArrayXd damping = Eigen::ArrayXd::Constant(1, 2e-6);
    const Law law = Law::of<Jkr>();
    const ImpactBatchResult expected = solve_impacts(
        {law, law.default_detachment(), DampingLaw::constant, contact_of(mass, radius), damping, s.velocity});
    CHECK(same_bits(overlap, expected.maximum_overlap));
    CHECK(same_bits(time, expected.approach_time));
    CHECK(same_bits(restitution, expected.restitution));

    const double wanted = 0.4;
    const ashimpact_column measured[] = {
        {"diameter", s.diameter.data(), 1}, {"velocity", s.velocity.data(), 1}, {"restitution", &wanted, 0}};
    std::vector<double> found(s.size());
    const ashimpact_output damping_output[] = {{"damping", found.data()}};
    REQUIRE(ashimpact_solve_dampings(handle.get(), s.size(), measured, 3, damping_output, 1, nullptr) ==
            ASHIMPACT_OK);
    const ashimpact_column back[] = {measured[0], measured[1], {"damping", found.data(), 1}};
    std::size_t reachable = 0;
    for (std::size_t i = 0; i < s.size(); i += 13) {
        if (std::isnan(found[i])) continue;
        const ashimpact_column one[] = {{"diameter", s.diameter.data() + i, 1},
                                        {"velocity", s.velocity.data() + i, 1},
                                        {"damping", found.data() + i, 1}};
        double e = 0.0;
        const ashimpact_output one_output[] = {{"restitution", &e}};
        REQUIRE(ashimpact_solve_impacts(handle.get(), 1, one, 3, one_output, 1, nullptr) == ASHIMPACT_OK);
        CHECK(e == doctest::Approx(wanted).epsilon(1e-9));
        ++reachable;
    }
    CHECK(reachable > 50);
    CHECK(back[2].values == found.data());
}

TEST_CASE("C interface: the headers name every detachment, and every damping law with its unit") {
    for (const std::string name : {"/ashimpact.h", "/ashimpact/model.hpp"}) {
        std::ifstream file(ASHIMPACT_HEADERS + name);
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        CAPTURE(name);
        for (const Detachment detachment : all_values<Detachment>)
            CHECK(text.find(name_of(detachment)) != std::string::npos);
        for (const DampingLaw law : all_values<DampingLaw>)
            CHECK(text.find(std::string(name_of(law)) + " [" + std::string(unit_of(law)) + "]") !=
                  std::string::npos);
    }
}

TEST_CASE("C interface: what is wrong, in one line with what is allowed") {
    const Handle handle("dmt", nullptr, nullptr, 4);
    ashimpact_error error;
    const ashimpact_parameter modulus{"contact_modulus", 60e9};
    struct Refused {
        const char* law;
        const char* detachment;
        const char* damping_law;
        std::vector<ashimpact_parameter> parameters;
        const char* said;
    };
    for (const Refused& c : std::vector<Refused>{
             {nullptr, nullptr, nullptr, {modulus}, "hertz"},
             {"dmt", "pull-off", nullptr, {modulus}, "zero-overlap"},
             {"dmt", nullptr, "linear", {modulus}, "tsuji"},
             {"dmt", nullptr, nullptr, {}, "contact_modulus is missing"},
             {"dmt", nullptr, nullptr, {modulus, modulus}, "twice"},
             {"dmt", nullptr, nullptr, {modulus, {"gamma", 1.0}}, "work_of_adhesion"},
             {"dmt", nullptr, nullptr, {modulus, {nullptr, 1.0}}, "unknown parameter"},
             {"dmt", nullptr, nullptr, {modulus, {"density", 2160.0}, {"mass", 1e-9}}, "beside density"},
             {"dmt", nullptr, nullptr, {modulus, {"damping", -1.0}}, "damping"},
             {"dmt", nullptr, nullptr, {{"contact_modulus", NAN}}, "contact_modulus"}}) {
        ashimpact_model* model = nullptr;
        CHECK(ashimpact_open(c.law, c.detachment, c.damping_law, c.parameters.data(), c.parameters.size(),
                             &model, &error) == ASHIMPACT_INPUT_ERROR);
        CHECK(model == nullptr);
        CHECK(std::string(error.message).find(c.said) != std::string::npos);
    }

    Spheres s = spheres(5000);
    s.velocity[4321] = -1.0;
    std::vector<double> restitution(s.size());
    CHECK(ashimpact_restitutions(handle.get(), s.size(), s.diameter.data(), s.velocity.data(),
                                 restitution.data(), &error) == ASHIMPACT_INPUT_ERROR);
    CHECK(std::string(error.message).find("impact 4321: velocity") == 0);
    double e = 0.0;
    CHECK(ashimpact_restitution(handle.get(), 1e-6, NAN, &e, &error) == ASHIMPACT_INPUT_ERROR);
    CHECK(std::string(error.message).find("velocity") == 0);
    const ashimpact_column velocity{"velocity", s.velocity.data(), 1};
    const ashimpact_output restitution_output{"restitution", &e};
    const ashimpact_column diameter{"diameter", s.diameter.data(), 1};
    const std::array adhesive{modulus, ashimpact_parameter{"density", 2160.0},
                              ashimpact_parameter{"work_of_adhesion", 0.3}};
    for (const auto& [law, count, said] : {std::tuple{"jkr", 2, "work_of_adhesion is missing"},
                                           {"thornton-ning", 3, "yield_pressure is missing"}}) {
        ashimpact_model* model = nullptr;
        REQUIRE(ashimpact_open(law, nullptr, nullptr, adhesive.data(), static_cast<std::size_t>(count),
                               &model, nullptr) == ASHIMPACT_OK);
        CHECK(ashimpact_restitution(model, 1e-6, 1.0, &e, &error) == ASHIMPACT_INPUT_ERROR);
        CHECK(std::string(error.message).find(said) == 0);
        ashimpact_close(model);
    }
    struct RefusedCall {
        std::vector<ashimpact_column> columns;
        std::vector<ashimpact_output> outputs;
        const char* said;
    };
    for (const RefusedCall& c : std::vector<RefusedCall>{
             {{velocity}, {restitution_output}, "diameter is missing"},
             {{velocity}, {{"overlap", &e}}, "maximum_overlap"},
             {{diameter, velocity, velocity}, {restitution_output}, "velocity is given twice"},
             {{diameter, velocity, {"effective_radius", s.diameter.data(), 1}}, {}, "beside diameter"},
             {{diameter, velocity, {"restitution", &e, 0}}, {}, "uses no column restitution"},
             {{diameter, velocity},
              {restitution_output, restitution_output},
              "restitution is given twice"}}) {
        CHECK(ashimpact_solve_impacts(handle.get(), 1, c.columns.data(), c.columns.size(), c.outputs.data(),
                                      c.outputs.size(), &error) == ASHIMPACT_INPUT_ERROR);
        CHECK(std::string(error.message).find(c.said) != std::string::npos);
    }
    CHECK(ashimpact_restitutions(handle.get(), 0, nullptr, nullptr, nullptr, &error) == ASHIMPACT_OK);
    CHECK(std::string(error.message).empty());
}

TEST_CASE("C interface: a note names what changes nothing with the law") {
    ashimpact_error error;
    ashimpact_model* model = nullptr;
    REQUIRE(ashimpact_open("hertz", nullptr, nullptr, constants.data(), constants.size(), &model, &error) ==
            ASHIMPACT_OK);
    CHECK(std::string(error.message) ==
          "work_of_adhesion: hertz does not use it, so it changes nothing; "
          "yield_pressure: hertz never yields, so it changes nothing");
    const double numbers[] = {44e-6, 2.0};
    double e = 0.0;
    const ashimpact_column columns[] = {
        {"diameter", numbers, 0}, {"velocity", numbers + 1, 0}, {"tabor", numbers + 1, 0}};
    const ashimpact_output output{"restitution", &e};
    for (const std::size_t count : {2U, 3U}) {
        CHECK(ashimpact_solve_impacts(model, 1, columns, count, &output, 1, &error) == ASHIMPACT_OK);
        CHECK(std::string(error.message) ==
              (count == 3 ? "tabor: hertz does not use it, so it changes nothing" : ""));
    }
    ashimpact_close(model);
    const Handle handle("dmt", nullptr, nullptr, 4);
    CHECK(ashimpact_solve_impacts(handle.get(), 1, columns, 2, &output, 1, &error) == ASHIMPACT_OK);
    CHECK(std::string(error.message).empty());
}

TEST_CASE("C interface: floating-point traps, flags and modes of the caller are neither disturbed nor used") {
    const Handle handle("jkr", nullptr, nullptr, 4);
    const Spheres s = spheres(1000);
    const std::vector<double> calm = restitutions(handle, s);
    std::vector<double> harsh(s.size());
    std::vector<double> critical(s.size());
    std::fenv_t before;
    fegetenv(&before);
    const unsigned int mode = _mm_getcsr();
    feclearexcept(FE_ALL_EXCEPT);
    fesetround(FE_UPWARD);
    _mm_setcsr(_mm_getcsr() | 0x8040U);  // denormal numbers flushed to zero, as -ffast-math has it
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW);
    const unsigned int harsh_mode = _mm_getcsr();
    const ashimpact_status done = ashimpact_restitutions(handle.get(), s.size(), s.diameter.data(),
                                                         s.velocity.data(), harsh.data(), nullptr);
    const ashimpact_status also_done =
        ashimpact_critical_velocities(handle.get(), s.size(), s.diameter.data(), critical.data(), nullptr);
    double e = 0.0;
    const ashimpact_status refused = ashimpact_restitution(handle.get(), NAN, 1.0, &e, nullptr);
    const unsigned int mode_after = _mm_getcsr();
    const int traps_after = fegetexcept();
    const int rounding_after = fegetround();
    fesetenv(&before);
    _mm_setcsr(mode);
    CHECK(done == ASHIMPACT_OK);
    CHECK(also_done == ASHIMPACT_OK);
    CHECK(refused == ASHIMPACT_INPUT_ERROR);
    CHECK(mode_after == harsh_mode);
    CHECK(traps_after == (FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW));
    CHECK(rounding_after == FE_UPWARD);
    CHECK(std::ranges::equal(calm, harsh));
}

TEST_CASE("C interface: single calls leave flags, control words and traps of the caller as they are") {
    const Handle handle("jkr", nullptr, nullptr, 4);
    const Handle scalar("maugis-dugdale", nullptr, nullptr, 4);  // computed in the x87 unit too
    const std::array<const ashimpact_model*, 2> models{handle.get(), scalar.get()};
    std::array<double, 2> calm{};
    for (std::size_t i = 0; i < 2; ++i) {
        REQUIRE(ashimpact_restitution(models[i], 20e-6, 2.0, &calm[i], nullptr) == ASHIMPACT_OK);
    }
    std::fenv_t before;
    fegetenv(&before);
    for (const int raised : {0, FE_INVALID | FE_INEXACT}) {
        for (const int traps : {0, FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW}) {
            for (const int precision : {0x0300, 0x0200}) {  // of the x87 unit: extended, double
                CAPTURE(raised);
                CAPTURE(traps);
                CAPTURE(precision);
                feclearexcept(FE_ALL_EXCEPT);
                feraiseexcept(raised);
                unsigned short control = 0;
                __asm__ volatile("fnstcw %0" : "=m"(control));
                control = static_cast<unsigned short>((control & ~0x0300) | precision);
                __asm__ volatile("fldcw %0" : : "m"(control));
                feenableexcept(traps);
                __asm__ volatile("fnstcw %0" : "=m"(control));
                const unsigned int sse = _mm_getcsr();
                std::array<double, 2> harsh{};
                for (std::size_t i = 0; i < 2; ++i) {
                    ashimpact_restitution(models[i], 20e-6, 2.0, &harsh[i], nullptr);
                }
                const unsigned int sse_after = _mm_getcsr();
                unsigned short control_after = 0;
                unsigned short status_after = 0;
                __asm__ volatile("fnstcw %0" : "=m"(control_after));
                __asm__ volatile("fnstsw %0" : "=m"(status_after));
                const int flags_after = fetestexcept(FE_ALL_EXCEPT);
                fesetenv(&before);
                CHECK(sse_after == sse);
                CHECK(control_after == control);
                CHECK(flags_after == raised);
                CHECK((status_after & FE_ALL_EXCEPT & ~raised) == 0);
                CHECK(harsh == calm);
            }
        }
    }
}

TEST_CASE("C interface: many threads share a handle and make its tables together") {
    // A law and damping law that no other test of this program has used: its tables are made here.
    const Handle handle("brach-dunn", nullptr, "contact-radius", 3);
    const Spheres s = spheres(4000);
    constexpr std::size_t threads = 4;
    std::array<std::vector<double>, threads> restitution;
    std::vector<std::thread> crew;
    for (std::size_t t = 0; t < threads; ++t) {
        restitution[t].resize(s.size());
        crew.emplace_back([&, t] {
            // Some one by one, some at once, from opposite ends.
            for (std::size_t k = 0; k < s.size(); ++k) {
                const std::size_t i = t % 2 == 0 ? k : s.size() - 1 - k;
                const auto place = static_cast<Eigen::Index>(i);
                ashimpact_restitution(handle.get(), s.diameter[place], s.velocity[place], &restitution[t][i],
                                      nullptr);
            }
        });
    }
    for (std::thread& thread : crew) thread.join();
    for (std::size_t t = 1; t < threads; ++t) CHECK(restitution[t] == restitution[0]);
    CHECK(restitutions(handle, s) == restitution[0]);
}
