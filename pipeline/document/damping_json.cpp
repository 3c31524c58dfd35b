// SPDX-License-Identifier: GPL-3.0-or-later
// Dampings of the impacts, and fits to them.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/quantities/checks.hpp"
#include "pipeline/document/fields.hpp"
#include "pipeline/document/results_json.hpp"

namespace ashimpact {

void fields(auto& io, Is<UnreachableImpact> auto& impact) {
    io("number", impact.number);
    io("velocity", impact.velocity, Dimension::velocity);
    io("restitution", impact.restitution, Dimension::fraction);
    io.lenient("reason", impact.reason);
}

void fields(auto& io, Is<PartRange> auto& range) {
    io("part", range.part);
    io("from", range.from, Dimension::velocity);
    io("to", range.to, Dimension::velocity);
}

void fields(auto& io, Is<RisingRange> auto& rising) {
    io("to", rising.to, Dimension::velocity);
    io.lenient("falls_beyond", rising.falls_beyond);
}

void inversion_fields(auto& io, Is<DampingSeries> auto& series) {
    const Dimension damping = dimension_of(io.damping_law());
    io.lenient("number", series.number, Dimension::fraction);
    io("velocity", series.velocity, Dimension::velocity);
    io("restitution", series.restitution, Dimension::fraction);
    io.lenient("greatest_restitution", series.greatest_restitution, Dimension::fraction);
    io("damping", series.damping, damping);
    io.unless_empty("damping_uncertainty", series.damping_uncertainty, damping);
    io("contact_time", series.contact_time, Dimension::time);
    io.lenient("captured_at", series.captured_at, Dimension::velocity);
    io.unless_empty("capturing_damping", series.capturing_damping, damping);
    io.lenient("unreachable", series.unreachable);
}

void fields(auto& io, Is<AngleClass> auto& each) {
    io("from", each.from, Dimension::angle);
    io("to", each.to, Dimension::angle);
    io("rebounds", each.rebounds);
    io("difference", each.difference, Dimension::fraction);
    io("standard_uncertainty", each.standard_uncertainty, Dimension::fraction);
}

void fields(auto& io, Is<AngleComparison> auto& angles) {
    io("classes", angles.classes);
    io("probability", angles.probability, Dimension::fraction);
}

void part_fields(auto& io, Is<DampingSeries> auto& series) {
    io.lenient("parts", series.parts);
    io.lenient("outliers", series.outliers);
    io.unless_empty("parts_note", series.parts_note);
    io.unless_empty("angles", series.angles);
}

template <class Io>
void fields(Io& io, Is<DampingSeries> auto& series) {
    io("origin", series.origin);
    inversion_fields(io, series);
    part_fields(io, series);
    io("rising_branch", series.rising);
    io.unless_empty("rising_branch_note", series.rising_note);
    io.lenient("map_accuracy", series.map_accuracy);
    const std::size_t count = series.velocity.size();
    if constexpr (Io::reads)
        if (count != series.restitution.size() || count != series.damping.size())
            io.node().fail("the columns differ in length", "columns of one length");
}

void fields(auto& io, Is<SampleDamping> auto& sample) {
    io("name", sample.name);
    io.under_laws(sample.laws, {"name"});
}

Json inversion_json(const DampingSeries& series, DampingLaw law) {
    FieldWriter writer(law);
    inversion_fields(writer, series);
    return std::move(writer).json();
}

Json parts_json(const DampingSeries& series) {
    FieldWriter writer(DampingLaw::constant);
    part_fields(writer, series);
    return std::move(writer).json();
}

Json rising_branch_json(double upper, bool falls_beyond) {
    return to_json(RisingRange{upper, falls_beyond}, DampingLaw::constant);
}

template Json to_json(const DampingStageResult& result, DampingLaw law);
template DampingStageResult from_json(const View& result, DampingLaw law);

namespace {

constexpr FieldColumn<FittedRebound> residual_columns[]{
    {"restitution", &FittedRebound::restitution, Dimension::fraction},
    {"distance", &FittedRebound::distance, Dimension::fraction},
    {"leverage", &FittedRebound::leverage, Dimension::fraction},
    {"deleted_distance", &FittedRebound::deleted_distance, Dimension::fraction},
    {"influence", &FittedRebound::influence, Dimension::damping},
    {"weight", &FittedRebound::weight, Dimension::fraction}};

/// The rebounds of a fit as columns, without those that are not known.
Json residuals_json(const DampingCurveFit& fit) {
    std::vector<double> numbers;
    for (const FittedRebound& rebound : fit.rebounds)
        numbers.push_back(static_cast<double>(rebound.index + 1));
    Json json{{"number", column_json(numbers, Dimension::fraction)}};
    for (const auto& column : residual_columns) {
        if (column.member == &FittedRebound::weight && !fit.options.robust) continue;
        std::vector<double> values;
        for (const FittedRebound& rebound : fit.rebounds) values.push_back(rebound.*column.member);
        if (std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
            json[std::string(column.key)] = column_json(values, column.dimension);
    }
    return json;
}

std::vector<FittedRebound> read_residuals(const View& node) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<FittedRebound> rebounds;
    for (const double number : node.at("number").column(Dimension::fraction))
        rebounds.push_back(
            {static_cast<std::size_t>(number) - 1, unknown, unknown, unknown, unknown, unknown, 1});
    for (const auto& column : residual_columns) {
        const auto member = node.find(column.key);
        if (!member) continue;
        const auto values = member->column(column.dimension);
        if (values.size() != rebounds.size())
            node.fail("the columns differ in length", "columns of one length");
        for (std::size_t i = 0; i < values.size(); ++i) rebounds[i].*column.member = values[i];
    }
    return rebounds;
}

Json excluded_json(const std::vector<ExcludedRebound>& excluded) {
    Json numbers = Json::array();
    for (const ExcludedRebound& rebound : excluded) numbers.push_back(rebound.index + 1);
    return numbers;
}

std::vector<ExcludedRebound> read_excluded(const View& numbers) {
    std::vector<ExcludedRebound> excluded;
    for (const View& number : numbers.elements())
        excluded.push_back({static_cast<std::size_t>(number.integer()) - 1, Exclusion::above_reach});
    return excluded;
}

/// A square matrix of that many rows.
Eigen::MatrixXd read_square(const View& matrix, Eigen::Index size) {
    const auto rows = matrix.at("values").elements();
    Eigen::MatrixXd square(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const auto row = rows[static_cast<std::size_t>(i)].column(Dimension::fraction);
        if (static_cast<Eigen::Index>(row.size()) != size)
            matrix.fail("the matrix is not square", "order + 1 rows and columns");
        square.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), size);
    }
    return square;
}

/// Sets the polynomial of a fit, which its artifact repeats in parts.
void read_polynomial(const View& node, DampingCurveFit& fit) {
    const auto coefficients = node.at("coefficients").column(Dimension::damping);
    const auto size = static_cast<Eigen::Index>(coefficients.size());
    fit.damping.coefficients = Eigen::Map<const Eigen::VectorXd>(coefficients.data(), size);
    if (size > 0 && !(coefficients.front() > 0))
        node.at("coefficients").fail("the first, the critical damping, is not positive", "> 0 kg/s");
    if (size > 0)
        require_agreement(node.at("critical_damping"), coefficients.front(), Dimension::damping,
                          "is not the first of the coefficients", "these");
    const View covariance = node.at("covariance");
    if (size != fit.options.order + 1 || covariance.at("values").elements().size() != coefficients.size())
        node.fail("coefficients and covariance do not belong to the order", "order + 1 of each");
    fit.covariance = read_square(covariance, size);
    fit.critical_damping.value = fit.damping.critical_damping();
}

/// The scatter of the impacts: a factor on the noise, or the noise itself where it is not known.
void scatter_field(auto& io, auto& fit) {
    const auto written = [&](double scatter) {
        return quantity_json(scatter, fit.noise_known ? "1" : "m/s");
    };
    const auto read = [](const View& scatter) { return scatter.at("value").number(Dimension::fraction); };
    io.by_hand("scatter", fit.scatter, written, read);
}

}  // namespace

template <class Io>
void fields(Io& io, Is<DampingCurveFit> auto& fit) {
    const auto if_known = [&](double value) { return fit.noise_known ? Json(value) : Json(nullptr); };
    const auto number = [](const View& node) { return node.number(Dimension::fraction); };
    const auto residuals = [&](const auto& /*rebounds*/) { return residuals_json(fit); };
    io("order", fit.options.order);
    io("robust", fit.options.robust);
    if constexpr (Io::reads) {
        fit.probability = 1;
    } else {
        const Eigen::VectorXd& coefficients = fit.damping.coefficients;
        io("coefficients", std::vector<double>(coefficients.begin(), coefficients.end()), Dimension::damping);
        io.json("covariance", {{"values", matrix_json(fit.covariance)}, {"unit", "(kg/s)2"}});
    }
    io.estimate("critical_damping", fit.critical_damping, Dimension::damping);
    io.estimate("critical_velocity", fit.critical_velocity, Dimension::velocity);
    io.derived("rebounds", fit.rebounds.size());
    // chi^2 and its probability mean nothing where the noise is estimated from the scatter itself.
    io.by_hand("chi_squared", fit.chi_squared, if_known, number);
    io.lenient("degrees_of_freedom", fit.degrees_of_freedom);
    io.by_hand("probability", fit.probability, if_known, number);
    io.lenient("noise_known", fit.noise_known);
    scatter_field(io, fit);
    io("prediction_error", fit.prediction_error, NullIfNotFinite{});
    io("restitution_range", fit.restitutions);
    io("extrapolation", fit.extrapolation, NullIfNotFinite{});
    io.by_hand("residuals", fit.rebounds, residuals, read_residuals);
    io.by_hand("excluded", fit.excluded, excluded_json, read_excluded);
    if constexpr (Io::reads) read_polynomial(io.node(), fit);
}

void fields(auto& io, Is<EstimatedDamping> auto& curve) {
    io("velocity", curve.velocity, Dimension::velocity);
    io("damping", curve.damping, Dimension::damping);
}

template <class Io>
void fields(Io& io, Is<DampingEstimate> auto& estimate) {
    io.derived("method", VelocityMethod::estimate);
    io.estimate("critical_damping", estimate.critical_damping, Dimension::damping);
    io.estimate("critical_velocity", estimate.critical_velocity, Dimension::velocity);
    io.lenient("rebounds", estimate.rebounds);
    io.lenient("captures", estimate.captures);
    io.lenient("noise_known", estimate.noise_known);
    scatter_field(io, estimate);
    io.lenient("particle_scatter", estimate.particle_scatter);
    io.unless_empty("curve", estimate.curve);
    if constexpr (Io::reads) {
        if (!(estimate.critical_damping.value > 0))
            io.node().at("critical_damping").fail("the critical damping is not positive", "> 0 kg/s");
        if (const auto& curve = estimate.curve;
            curve && (curve->velocity.size() < 2 || curve->velocity.size() != curve->damping.size()))
            io.node().at("curve").fail("is no curve", "two velocities or more, with a damping each");
    }
}

void fields(auto& io, Is<FitComparison> auto& comparison) {
    io("critical_damping_ratio", comparison.critical_damping_ratio, NullIfNotFinite{});
    io("critical_velocity_ratio", comparison.critical_velocity_ratio, NullIfNotFinite{});
    io.lenient("consistent", comparison.consistent);
    io("statement", comparison.statement);
}

Json damping_fit_json(const DampingCurveFit& fit) {
    return to_json(fit, DampingLaw::constant);
}

Json damping_estimate_json(const DampingEstimate& estimate) {
    return to_json(estimate, DampingLaw::constant);
}

Json comparison_json(const FitComparison& comparison) {
    return to_json(comparison, DampingLaw::constant);
}

namespace {

/// The covariance of a, b, c from that of c, b, a.
Json covariance_json(const Eigen::Matrix3d& covariance, DampingLaw law) {
    return {{"parameters", {"a", "b", "c"}},
            {"values", matrix_json(covariance.reverse())},
            {"unit", fmt::format("({})2", unit_of(law))}};
}

Eigen::Matrix3d read_covariance(const View& node) {
    const auto rows = node.at("values").elements();
    if (rows.size() != 3) node.at("values").fail("is not the covariance of a, b and c", "three rows");
    Eigen::Matrix3d covariance;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const View& place = rows[static_cast<std::size_t>(i)];
        const auto row = place.column(Dimension::fraction);
        if (row.size() != 3) place.fail("is not a row of three", "three numbers");
        covariance.row(i) = Eigen::Map<const Eigen::RowVector3d>(row.data());
    }
    return covariance.reverse();
}

/// Checks that a fit has one critical damping, and one polynomial, wherever the artifact repeats them.
void require_one_fit(const View& node, const LawFit& fit, Dimension dimension) {
    const View c = node.at("c");
    require_agreement(node.at("critical_damping"), c.number(dimension), dimension,
                      "is not the c of the same fit", "c");
    if (fit.extrapolated) {
        const Eigen::VectorXd& coefficients = fit.extrapolated->damping.coefficients;
        constexpr std::array names{"c", "b", "a"};
        for (Eigen::Index i = 0; i < std::min<Eigen::Index>(3, coefficients.size()); ++i)
            require_agreement(node.at(names.at(static_cast<std::size_t>(i))), coefficients[i], dimension,
                              "is not that of \"extrapolated\"", "or remove \"extrapolated\" and \"direct\"");
    } else if (fit.estimate) {
        require_agreement(c, fit.estimate->critical_damping.value, dimension,
                          "is not the critical damping of \"direct\"", "or remove \"direct\"");
    }
    const View critical = node.at("critical_damping");
    at_place(critical.pointer(),
             [&] { require_not_negative("critical damping", fit.critical_damping, dimension); });
}

}  // namespace

template <class Io>
void fields(Io& io, Is<LawFit> auto& fit) {
    const Dimension damping = dimension_of(io.damping_law());
    if constexpr (Io::reads) fit.damping = DampingPolynomial::quadratic(0, 0, 0);
    for (Eigen::Index power = 2; power >= 0; --power) {
        Quantity coefficient = make_quantity(fit.damping.coefficients[power], damping);
        if (fit.covariance)
            coefficient.standard_uncertainty = std::sqrt(std::max(0.0, (*fit.covariance)(power, power)));
        io(std::string_view("cba").substr(static_cast<std::size_t>(power), 1), coefficient, damping);
        if constexpr (Io::reads) fit.damping.coefficients[power] = coefficient.value;
    }
    Quantity critical = make_quantity(fit.critical_damping, damping, fit.critical_damping_uncertainty);
    io("critical_damping", critical, damping);
    if (Io::reads || fit.covariance)
        io.by_hand(
            "covariance", fit.covariance,
            [&](const auto& covariance) { return covariance_json(*covariance, io.damping_law()); },
            read_covariance);
    io.unless_empty("method", fit.method);
    if (fit.method != FitMethod::estimate) {
        io.unless_empty("residual_deviation", fit.residual_deviation, damping);
        io.lenient("degrees_of_freedom", fit.degrees_of_freedom);
        io.lenient("points", fit.points);
        io.lenient("points_beyond_rising_branch", fit.points_beyond);
        io.unless_empty("restitution_range", fit.restitution_range);
    }
    io.unless_empty("extrapolated", fit.extrapolated);
    io.lenient("origin", fit.origin);
    io.unless_empty("direct", fit.estimate);
    io.unless_empty("comparison", fit.comparison);
    if constexpr (Io::reads) {
        fit.critical_damping = critical.value;
        fit.critical_damping_uncertainty = critical.standard_uncertainty;
        require_one_fit(io.node(), fit, damping);
    }
}

void fields(auto& io, Is<SampleFit> auto& sample) {
    io("name", sample.name);
    io.under_laws(sample.laws, {"name"});
}

template Json to_json(const FitResult& result, DampingLaw law);
template FitResult from_json(const View& result, DampingLaw law);

}  // namespace ashimpact
