#include "apps/lab/figures/drift_figure.h"

#include "engine/core/units.h"
#include "evaluation/drift/drift_experiment.h"

#include <array>
#include <span>

namespace carina::lab
{
namespace
{

constexpr double kFullSpeed = 100.0; ///< deg/s, and mm/s
constexpr std::array kParticipants{2.0, 3.0, 4.0, 5.0, 6.0};
constexpr std::array kDelays_ms{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0};
/// Of a path's constant delay: how long its queue is.
constexpr double kQueueShare = 0.05;

DriftSettings experimentOf(const FigureSettings& settings, std::string_view strategy, double speed)
{
    DriftSettings experiment;
    experiment.strategy = findSyncStrategy(strategy);
    experiment.script.actions = settings.actions;
    experiment.script.angularSpeed = degrees(speed).si;
    experiment.script.speed = millimetres(speed).si;
    experiment.scenario = settings.scenario;
    experiment.seed = settings.seed;
    return experiment;
}

double deg(double rad) { return inDegrees(radians(rad)); }
double mm(double m) { return inMillimetres(metres(m)); }

std::string withUnit(double speed, const char* unit)
{
    return std::to_string(static_cast<int>(speed)) + unit;
}

/// The figures of orientation and of position that one experiment makes.
struct FigurePair {
    DriftFigure orientation;
    DriftFigure position;
};

FigurePair pairOf(const DriftFigure& figure)
{
    FigurePair pair{figure, figure};
    pair.orientation.name += "-orientation";
    pair.orientation.yLabel = "orientation drift, deg";
    pair.orientation.yColumn = "orientation_deg";
    pair.position.name += "-position";
    pair.position.yLabel = "position drift, mm";
    pair.position.yColumn = "position_mm";
    return pair;
}

void append(std::vector<DriftFigure>& figures, FigurePair pair)
{
    figures.push_back(std::move(pair.orientation));
    figures.push_back(std::move(pair.position));
}

/// Gives every curve of a figure its trend.
Result<void> addTrends(DriftFigure& figure, int order)
{
    for (DriftCurve& curve : figure.curves) {
        auto trend = fitPolynomial(curve.x, curve.y, order);
        if (!trend)
            return tl::unexpected(trend.error());
        curve.trend = *std::move(trend);
    }
    return {};
}

Result<void> addTrends(std::vector<DriftFigure>& figures, const FigurePair& pair, int order)
{
    FigurePair withTrends = pair;
    for (DriftFigure* figure : {&withTrends.orientation, &withTrends.position})
        if (const auto added = addTrends(*figure, order); !added)
            return added;
    append(figures, std::move(withTrends));
    return {};
}

Result<FigurePair> measureActions(const FigureSettings& settings, const std::string& strategy)
{
    FigurePair pair = pairOf({.name = "drift-by-action-" + strategy,
                              .title = "Drift at each action, 2 participants: " + strategy,
                              .network = settings.scenario.name + settings.source.network,
                              .xLabel = "number of the action",
                              .xColumn = "action"});
    const bool isAngleRaw = settings.isAngleRaw && strategy == "none";
    if (isAngleRaw) {
        pair.orientation.yLabel = "2 acos(w) as in 2004, deg";
        pair.orientation.yColumn = "raw_angle_deg";
        pair.orientation.isAngleRaw = true;
    }
    settings.onCurve(pair.orientation.title);
    const auto figures = settings.source.run(experimentOf(settings, strategy, kFullSpeed));
    if (!figures)
        return tl::unexpected(figures.error());
    DriftCurve orientation{.name = withUnit(kFullSpeed, " deg/s")};
    DriftCurve position{.name = withUnit(kFullSpeed, " mm/s")};
    for (const ActionDrift& action : figures->actions) {
        const double number = static_cast<double>(orientation.x.size()) + 1.0;
        orientation.x.push_back(number);
        orientation.y.push_back(deg(isAngleRaw ? action.rawAngle : action.angle));
        position.x.push_back(number);
        position.y.push_back(mm(action.distance));
    }
    pair.orientation.curves = {std::move(orientation)};
    pair.position.curves = {std::move(position)};
    return pair;
}

/// A curve of one number of each of some experiments.
template <class Number>
DriftCurve curveOf(std::string name, std::span<const double> x,
                   const std::vector<DriftFigures>& measured, Number number)
{
    DriftCurve curve{.name = std::move(name), .x = {x.begin(), x.end()}};
    for (const DriftFigures& figures : measured)
        curve.y.push_back(number(figures));
    return curve;
}

double atEvent_deg(const DriftFigures& figures) { return deg(figures.atEvent); }

double atEvent_mm(const DriftFigures& figures)
{
    double mean = 0.0;
    for (const ActionDrift& action : figures.actions)
        mean += mm(action.distance) / static_cast<double>(figures.actions.size());
    return mean;
}

Result<FigurePair> measureParticipants(const FigureSettings& settings, const std::string& strategy)
{
    FigurePair pair = pairOf({.name = "drift-by-participants-" + strategy,
                              .title = "Mean drift at the actions: " + strategy,
                              .network = settings.scenario.name + settings.source.network,
                              .xLabel = "number of participants",
                              .xColumn = "participants"});
    for (const double speed : settings.source.speeds) {
        settings.onCurve(pair.orientation.title + ", " + withUnit(speed, " deg/s"));
        DriftSettings experiment = experimentOf(settings, strategy, speed);
        std::vector<DriftFigures> measured;
        for (const double count : kParticipants) {
            experiment.participants = static_cast<std::uint16_t>(count);
            const auto figures = settings.source.run(experiment);
            if (!figures)
                return tl::unexpected(figures.error());
            measured.push_back(*figures);
        }
        pair.orientation.curves.push_back(
            curveOf(withUnit(speed, " deg/s"), kParticipants, measured, atEvent_deg));
        pair.position.curves.push_back(
            curveOf(withUnit(speed, " mm/s"), kParticipants, measured, atEvent_mm));
    }
    return pair;
}

/// A path whose delay is so long on average.
DriftScenario pathOf(double delay_ms)
{
    const double constant_ms = delay_ms / (1.0 + kQueueShare);
    DriftScenario scenario;
    scenario.forward = {.delay = fromSeconds(constant_ms * 1e-3),
                        .jitter = PathProfile::Jitter::Exponential,
                        .jitterScale = fromSeconds(kQueueShare * constant_ms * 1e-3)};
    scenario.backward = scenario.forward;
    return scenario;
}

} // namespace

std::size_t curvesToMeasure(const DriftSource& source)
{
    return source.byAction.size() + source.byParticipants.size() * source.speeds.size()
           + source.byDelay.size();
}

Result<std::vector<DriftFigure>> figuresByAction(const FigureSettings& settings)
{
    std::vector<DriftFigure> figures;
    for (const std::string_view strategy : settings.source.byAction) {
        const int order = strategy == "none" ? kTrendOfNone : kTrendOfStrategies;
        const auto added =
            measureActions(settings, std::string{strategy}).and_then([&](const FigurePair& pair) {
                return addTrends(figures, pair, order);
            });
        if (!added)
            return tl::unexpected(added.error());
    }
    return figures;
}

Result<std::vector<DriftFigure>> figuresByParticipants(const FigureSettings& settings)
{
    std::vector<DriftFigure> figures;
    for (const std::string_view strategy : settings.source.byParticipants) {
        const auto added =
            measureParticipants(settings, std::string{strategy})
                .and_then([&](const FigurePair& pair) { return addTrends(figures, pair, 1); });
        if (!added)
            return tl::unexpected(added.error());
    }
    return figures;
}

Result<std::vector<DriftFigure>> figuresByDelay(const FigureSettings& settings)
{
    FigurePair pair =
        pairOf({.name = "drift-by-delay",
                .title = "Mean drift over time, 2 participants, 100 deg/s and 100 mm/s",
                .network = "without loss" + settings.source.network,
                .xLabel = "mean one-way delay from actor to viewer, ms",
                .xColumn = "delay_ms"});
    std::vector<DriftFigures> measured;
    for (const std::string_view strategy : settings.source.byDelay) {
        const std::string name{strategy};
        settings.onCurve(pair.orientation.title + ": " + name);
        DriftSettings experiment = experimentOf(settings, name, kFullSpeed);
        measured.clear();
        for (const double delay_ms : kDelays_ms) {
            experiment.scenario = pathOf(delay_ms);
            const auto figures = settings.source.run(experiment);
            if (!figures)
                return tl::unexpected(figures.error());
            measured.push_back(*figures);
        }
        pair.orientation.curves.push_back(curveOf(
            name, kDelays_ms, measured, [](const auto& of) { return deg(of.timeAverage); }));
        pair.position.curves.push_back(
            curveOf(name, kDelays_ms, measured, [](const auto& of) { return mm(of.position); }));
    }
    // The same for all strategies, for it is asked of the links.
    const std::string limit = "limit until heard";
    pair.orientation.curves.push_back(
        curveOf(limit, kDelays_ms, measured, [](const auto& of) { return deg(of.limit); }));
    pair.position.curves.push_back(
        curveOf(limit, kDelays_ms, measured, [](const auto& of) { return mm(of.positionLimit); }));
    for (DriftFigure* figure : {&pair.orientation, &pair.position})
        figure->isLogarithmic = figure->hasLimit = true;
    std::vector<DriftFigure> figures;
    append(figures, std::move(pair));
    return figures;
}

} // namespace carina::lab
