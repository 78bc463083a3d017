#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/registration/calibration/blade_calibration.h"
#include "engine/registration/calibration/tip_check.h"
#include "engine/registration/calibration/tube_calibration.h"
#include "engine/registration/error/error_bound.h"

#include <cmath>
#include <random>
#include <vector>

namespace carina::lab
{
namespace
{

namespace tool_option
{
constexpr Option kFle{"fle", "MM",
                      "root mean square error of each touch, 0.01 to 1; 0.35 unless given"};
constexpr Option kDraws{"draws", "N", "calibrations of each tool, 10 to 100000; 2000 unless given"};
constexpr Option kSeed{"seed", "N", "of the random errors; 1 unless given"};
} // namespace tool_option

namespace tool_key
{
constexpr Key kSchema{"schema", "carina.tool/1"};
constexpr Key kFle{"fle_mm", "as given"};
constexpr Key kDraws{"draws", "as given"};
constexpr Key kTube{"tube", "a tube of 300 mm, 10.2 mm thick, bent with a radius of 140 mm:"};
constexpr Key kBlade{"blade", "a curved laryngoscope of 130 mm: the same"};
constexpr Key kTouches{"touches", "of one calibration", 1};
constexpr Key kPredicted{"tip_predicted_mm", "error of the tip that the fits expect, RMS", 1};
constexpr Key kMeasured{"tip_error_mm", "error of the tip as it is, RMS", 1};
constexpr Key kWithin{"below_bound95", "share of the tips nearer than their 95 % bound", 1};
constexpr Key kRefused{"refused", "share of calibrations that were refused", 1};
constexpr Key kAlarms{"sound_called_bent", "share of the checks of a tool that is as it was", 1};
constexpr Key kFound{"bent_3mm_found", "share of the checks of one that was bent by 3 mm", 1};
} // namespace tool_key

const TubeRest kLabTube{.length = millimetres(300.0),
                        .bends = {1.0 / 0.14, 1.0 / 0.14},
                        .outerDiameter = millimetres(10.2)};
/// As the simulated one: sizes of ours.
const BladeShape kLabBlade{.heelWidth = millimetres(16.0),
                           .handle = millimetres(155.0),
                           .p_L_tip = {0.0, 0.012, -0.13},
                           .p_L_half = {0.0, -0.013, -0.065}};

/// A hand that strays from what it touches.
class StrayingTouch
{
public:
    StrayingTouch(Length fle, std::uint32_t seed)
        : m_random{seed}, m_part{0.0, fle.si / std::sqrt(3.0)}
    {
    }
    [[nodiscard]] Vec3 at(const Vec3& p)
    {
        return p + Vec3{m_part(m_random), m_part(m_random), m_part(m_random)};
    }

private:
    std::mt19937 m_random;
    std::normal_distribution<double> m_part;
};

/// The frame of the markers is that of the tool: the fit does not know.
Result<TubeCalibration> touchTube(StrayingTouch& hand)
{
    std::vector<TubeTouch> touches;
    for (const TubeTouchPlace& place : kTubePlaces)
        touches.push_back({place.part, hand.at(placeOnTube(kLabTube, place))});
    return calibrateTube(touches, kLabTube.outerDiameter);
}

Result<BladeCalibration> touchBlade(StrayingTouch& hand)
{
    std::vector<BladeTouch> touches;
    for (const BladePlace place : kBladePlaces)
        touches.push_back({place, hand.at(placeOnBlade(kLabBlade, place))});
    return calibrateBlade(touches);
}

template <class Calibrate>
QJsonObject measureTool(StrayingTouch& hand, int draws, const Vec3& p_NQ,
                        const Calibrate& calibrate, std::size_t touches)
{
    constexpr Length kBentBy = millimetres(3.0);
    double predicted = 0.0;
    double measured = 0.0;
    int fitted = 0;
    int within = 0;
    int alarms = 0;
    int found = 0;
    for (int i = 0; i < draws; ++i) {
        const auto fit = calibrate(hand);
        if (!fit)
            continue;
        ++fitted;
        const double off = (fit->p_NQ_tip() - p_NQ).norm();
        measured += off * off;
        predicted += fit->covariance_N.trace();
        within += metres(off) < errorBound(fit->covariance_N, fit->degrees);
        const auto isBent = [&](const Vec3& at) {
            return checkTip(fit->p_NQ_tip(), fit->covariance_N, fit->fle, fit->degrees, hand.at(at))
                .isBent();
        };
        alarms += isBent(p_NQ);
        found += isBent(p_NQ + kBentBy.si * Vec3::UnitY());
    }
    const auto share = [&](int count) { return fitted > 0 ? double(count) / fitted : 0.0; };
    const auto rms = [&](double sum) {
        return fitted > 0 ? inMillimetres(metres(std::sqrt(sum / fitted))) : 0.0;
    };
    return {{tool_key::kTouches, qint64(touches)},
            {tool_key::kPredicted, rms(predicted)},
            {tool_key::kMeasured, rms(measured)},
            {tool_key::kWithin, share(within)},
            {tool_key::kRefused, 1.0 - double(fitted) / draws},
            {tool_key::kAlarms, share(alarms)},
            {tool_key::kFound, share(found)}};
}

Result<QJsonObject> runTool(const Words& words)
{
    const auto fle = words.number(tool_option::kFle, 0.01, 1.0, 0.35);
    const auto draws = words.whole(tool_option::kDraws, 10, 100'000, 2000);
    const auto seed = words.whole(tool_option::kSeed, 0, 1'000'000, 1);
    if (!fle)
        return tl::unexpected(fle.error());
    if (!draws || !seed)
        return tl::unexpected((draws ? seed : draws).error());
    StrayingTouch hand{millimetres(*fle), std::uint32_t(*seed)};
    const QJsonObject tube =
        measureTool(hand, int(*draws), tipOfTube(kLabTube), touchTube, kTubePlaces.size());
    const QJsonObject blade =
        measureTool(hand, int(*draws), kLabBlade.p_L_tip, touchBlade, kBladePlaces.size());
    return QJsonObject{{tool_key::kSchema, QLatin1StringView{tool_key::kSchema.help}},
                       {tool_key::kFle, *fle},
                       {tool_key::kDraws, qint64(*draws)},
                       {tool_key::kTube, tube},
                       {tool_key::kBlade, blade}};
}

Use toolUse()
{
    return {.lines = {"[--fle MM] [--draws N] [--seed N]"},
            .text = "Calibrates a tube and a laryngoscope again and again by touches with random "
                    "errors, as the wizard does by touches with the stylus, and compares the error "
                    "of the tip with the expected one. Each calibration is followed by two checks "
                    "of the tip, of the tool as it was and of one that was bent.",
            .notes = {{"example", "carina-lab tool --fle 0.5"}},
            .options = {tool_option::kFle, tool_option::kDraws, tool_option::kSeed},
            .schema = tool_key::kSchema,
            .keys = {tool_key::kFle, tool_key::kDraws, tool_key::kTube, tool_key::kTouches,
                     tool_key::kPredicted, tool_key::kMeasured, tool_key::kWithin,
                     tool_key::kRefused, tool_key::kAlarms, tool_key::kFound, tool_key::kBlade}};
}

} // namespace

Command toolCommand()
{
    return {.name = "tool",
            .theme = "registration",
            .summary = "calibrates a tube and a laryngoscope and measures the error of the tip",
            .uses = {toolUse()},
            .reminder = "tool needs no file.",
            .experiment = runTool};
}

} // namespace carina::lab
