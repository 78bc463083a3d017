#include "apps/lab/anatomy/anatomy_sweep.h"

#include "apps/lab/anatomy/anatomy_page.h"
#include "apps/lab/anatomy/sweep_report.h"
#include "apps/lab/command/patient_options.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/core/monotonic_clock.h"

namespace carina::lab
{
namespace
{

constexpr std::int64_t kMostSeeds = 1'000'000;
constexpr std::int64_t kUsualSeeds = 100;
constexpr std::int64_t kMostLevel = 9;

struct SweepOrder {
    PatientParameters who;
    std::int64_t seeds = 0;
    std::optional<std::size_t> level;
    bool hasLimits = true;
};

Result<SweepOrder> orderOf(const Words& words)
{
    if (words.files().size() != 1 || words.has(anatomy_option::kSet))
        return words.refuse(QStringLiteral("sweep takes [--patient WHO] [--seeds N] [--level L] "
                                           "[--without-limits]."));
    const auto who = patientOption(words, BuiltinPatient::Adult);
    if (!who)
        return tl::unexpected(who.error());
    const auto seeds = words.whole(anatomy_option::kSeeds, 0, kMostSeeds, kUsualSeeds);
    if (!seeds)
        return tl::unexpected(seeds.error());
    const auto level = words.whole(anatomy_option::kLevel, 0, kMostLevel, kMostLevel);
    if (!level)
        return tl::unexpected(level.error());
    SweepOrder order{.who = *who,
                     .seeds = *seeds,
                     .level = {},
                     .hasLimits = !words.has(anatomy_option::kWithoutLimits)};
    if (words.has(anatomy_option::kLevel))
        order.level = std::size_t(*level);
    return order;
}

SweepReport swept(const DeformationSweep& sweep, const SweepOrder& order)
{
    SweepReport report;
    const auto add = [&](const DeformationCombination& combination) {
        report.add(combination, sweep.deformedBy(combination));
    };
    if (order.hasLimits)
        for (const DeformationCombination& combination : limitsOfDeformation())
            add(combination);
    for (std::int64_t seed = 1; seed <= order.seeds; ++seed)
        add(randomCombination(std::uint32_t(seed)));
    return report;
}

} // namespace

Result<QJsonObject> sweepPatient(const Words& words)
{
    const auto order = orderOf(words);
    if (!order)
        return tl::unexpected(order.error());
    const auto patient = patientFor(order->who);
    if (!patient)
        return tl::unexpected(patient.error());
    const auto sweep = DeformationSweep::of(*patient, order->level);
    if (!sweep)
        return tl::unexpected(sweep.error());
    const auto begin = monotonicNow();
    QJsonObject object = swept(*sweep, *order).object();
    object.insert(anatomy_sweep_key::kSweepTime, toSeconds(monotonicNow() - begin));
    object.insert(anatomy_sweep_key::kSchema, QLatin1StringView{anatomy_sweep_key::kSchema.help});
    object.insert(anatomy_sweep_key::kPatient,
                  words.has(kPatient) ? words.text(kPatient) : QStringLiteral("adult"));
    object.insert(anatomy_sweep_key::kLevel,
                  order->level ? QJsonValue{qint64(*order->level)} : QJsonValue{QJsonValue::Null});
    object.insert(anatomy_sweep_key::kSeeds, qint64(order->seeds));
    return object;
}

Use sweepUse()
{
    return {.lines = {"sweep [--patient WHO] [--seeds N] [--level L] [--without-limits]"},
            .text = "Makes a patient, an adult unless another is asked for, and deforms its "
                    "surfaces as the programs do: by head and neck, by the jaw, by the blade of a "
                    "laryngoscope on its way, lifted and levered, and by airway events, each at "
                    "its limits and all in combinations drawn at random. Counts surfaces that "
                    "intersect themselves then, and finds the smallest determinant of the "
                    "gradient. What moves as a rigid body is left out, and so is the breath.",
            .options = {kPatient, anatomy_option::kSeeds, anatomy_option::kLevel,
                        anatomy_option::kWithoutLimits},
            .schema = anatomy_sweep_key::kSchema,
            .keys = {anatomy_sweep_key::kPatient,
                     anatomy_sweep_key::kLevel,
                     anatomy_sweep_key::kSeeds,
                     anatomy_sweep_key::kCombinations,
                     anatomy_sweep_key::kSelfIntersecting,
                     anatomy_sweep_key::kFolded,
                     anatomy_sweep_key::kLeast,
                     anatomy_sweep_key::kDeterminant,
                     anatomy_sweep_key::kPart,
                     anatomy_sweep_key::kPlace,
                     anatomy_sweep_key::kParameters,
                     anatomy_sweep_key::kSeed,
                     anatomy_sweep_key::kNeckFlexion,
                     anatomy_sweep_key::kHeadExtension,
                     anatomy_sweep_key::kJawOpening,
                     anatomy_sweep_key::kJawForward,
                     anatomy_sweep_key::kBlade,
                     anatomy_sweep_key::kProgress,
                     anatomy_sweep_key::kLift,
                     anatomy_sweep_key::kLevering,
                     anatomy_sweep_key::kEvents,
                     anatomy_sweep_key::kParts,
                     anatomy_sweep_key::kPart,
                     anatomy_sweep_key::kInCombinations,
                     anatomy_sweep_key::kPartsLeast,
                     anatomy_sweep_key::kBad,
                     anatomy_sweep_key::kPairs,
                     anatomy_sweep_key::kSweepTime,
                     kAcceptable}};
}

} // namespace carina::lab
