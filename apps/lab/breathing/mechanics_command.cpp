#include "apps/lab/breathing/mechanics_command.h"

#include "apps/lab/breathing/mechanics_table.h"
#include "apps/lab/command/command_options.h"
#include "apps/lab/command/patient_options.h"
#include "apps/lab/command/patient_words.h"
#include "evaluation/waveforms/waveform_model.h"

#include <QJsonArray>

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr const char* kMechanics = "mechanics";
constexpr double kUsualFlow_lPerMin = 30.0;

constexpr std::string_view kMechanicsHelp =
    R"(mechanics [--patient WHO] [--rate-per-min R] [--position NAME]
    What the respiratory mechanics make of each condition at the severities 0.3, 0.6 and 0.9, after
    a minute of quiet breathing and of volume control through a tube with a PEEP of 5 cmH2O; R
    breaths per minute instead of as many as the patient breathes at rest. Conditions are normal,
    ards, copd, asthma, simple_pneumothorax, tension_pneumothorax, atelectasis, mainstem_intubation,
    obstruction and stiff_chest. NAME is supine (taken unless given), sitting, prone, right_lateral
    or left_lateral.
    schema            "carina.mechanics/1"
    position          how the patient lies
    patient           height_mm, weight_kg, age_years, rv_ml, frc_ml, tlc_ml,
                      compliance_ml_per_cmh2o at rest and resistance_cmh2o_s_per_l of the system,
                      all on the back, and the quiet breath: rate_per_min, tidal_volume_ml,
                      inspiratory_fraction
    seconds, rate_per_min
                      breathed in each case
    conditions        condition, severity, side, rest_volume_ml, compliance_ml_per_cmh2o at rest,
                      spontaneous and volume_control with figures of the last breath:
                      tidal_volume_ml (also _right_ml, _left_ml), peak_cmh2o, plateau_cmh2o,
                      auto_peep_cmh2o, alveolar_ventilation_l_per_min; and of the end:
                      right_lung_ml, left_lung_ml, right_pleura_cmh2o, left_pleura_cmh2o,
                      mediastinal_shift_mm (towards the patient's left)
mechanics --waveform FILE [--inspiratory-flow-l-per-min F]
    Finds resistance and compliance in a recorded ventilator by least squares, breath by breath,
    drives the mechanics with them and compares the pressure with the recorded one.
    FILE              a line "#samplerate,HZ", a line of names with pressure (cmH2O) and flow
                      (L/min), a line for each sample. Where all flows are empty, a ventilator is
                      assumed that drives F (30) in and lets out through a valve, found with the
                      lung; resistance and elastance then go with 1/F, but not their time constant
    schema            "carina.mechanics.waveform/1"
    samples, rate_hz  what was recorded
    flow              "recorded", or "assumed" with inspiratory_flow_l_per_min
    breaths           whole and fitted; unfit_breaths: whole, but R or C would not be above 0
    resistance_cmh2o_s_per_l, compliance_ml_per_cmh2o
                      [least, median, greatest] of the breaths
    time_constant_s   of the medians
    valve             pressure_cmh2o and resistance_cmh2o_s_per_l, where flow was assumed
    rms_cmh2o         modelled less recorded pressure, each breath with a lung of its own
    rms_one_lung_cmh2o  the same, all breaths with the median lung
    disconnected_s    time with an open tube, left out of all of this
)";

QJsonArray spreadOf(const WaveformModel& model, double (*figure)(const LinearLung&))
{
    double least = figure(model.median);
    double greatest = least;
    for (const FittedBreath& breath : model.breaths) {
        least = std::min(least, figure(breath.lung));
        greatest = std::max(greatest, figure(breath.lung));
    }
    return {least, figure(model.median), greatest};
}

double resistanceOf(const LinearLung& lung) { return inCmH2OSecondsPerLitre(lung.resistance); }
double complianceOf_ml(const LinearLung& lung) { return 1e3 * inLitresPerCmH2O(lung.compliance); }

QJsonObject describeModel(const RecordedWaveform& waveform, const std::vector<BreathPart>& parts,
                          const WaveformModel& model, double assumed_lPerMin)
{
    const auto open = std::ranges::count(parts, BreathPart::Disconnected);
    QJsonObject object{
        {QStringLiteral("schema"), QStringLiteral("carina.mechanics.waveform/1")},
        {QStringLiteral("samples"), qint64(waveform.pressure_cmH2O.size())},
        {QStringLiteral("rate_hz"), waveform.rate_hz},
        {QStringLiteral("flow"),
         model.valve ? QStringLiteral("assumed") : QStringLiteral("recorded")},
        {QStringLiteral("breaths"), qint64(model.breaths.size())},
        {QStringLiteral("unfit_breaths"), model.unfit},
        {QStringLiteral("resistance_cmh2o_s_per_l"), spreadOf(model, resistanceOf)},
        {QStringLiteral("compliance_ml_per_cmh2o"), spreadOf(model, complianceOf_ml)},
        {QStringLiteral("time_constant_s"),
         model.median.resistance.si * model.median.compliance.si},
        {QStringLiteral("rms_cmh2o"), inCmH2O(model.rms)},
        {QStringLiteral("rms_one_lung_cmh2o"), inCmH2O(model.rmsOneLung)},
        {QStringLiteral("disconnected_s"), double(open) / waveform.rate_hz}};
    if (model.valve) {
        object[QStringLiteral("inspiratory_flow_l_per_min")] = assumed_lPerMin;
        object[QStringLiteral("valve")] =
            QJsonObject{{QStringLiteral("pressure_cmh2o"), inCmH2O(model.valve->pressure)},
                        {QStringLiteral("resistance_cmh2o_s_per_l"),
                         inCmH2OSecondsPerLitre(model.valve->resistance)}};
    }
    return object;
}

Result<QJsonObject> describeWaveform(const QString& file, double assumed_lPerMin)
{
    const auto waveform = readWaveform(file);
    if (!waveform)
        return tl::unexpected(waveform.error());
    const std::vector<BreathPart> parts = breathParts(*waveform);
    const auto model = modelOf(*waveform, parts, litresPerSecond(assumed_lPerMin / 60.0));
    if (!model)
        return fail(model.error().code, file.toStdString() + " has " + model.error().detail + ".");
    return describeModel(*waveform, parts, *model, assumed_lPerMin);
}

Result<QJsonObject> describeTable(const QCommandLineParser& parser)
{
    const auto figures = figuresOption(parser, kMechanics, BuiltinPatient::Adult);
    if (!figures)
        return tl::unexpected(figures.error());
    RespiratorySettings healthy;
    healthy.build = buildOf(dimensionsFor(*figures).value());
    const auto position = positionOption(parser, kMechanics);
    if (!position)
        return tl::unexpected(position.error());
    healthy.position = *position;
    healthy.pattern = restingPattern(healthy.build);
    if (parser.isSet(QStringLiteral("rate-per-min"))) {
        const auto rate_perMin = numberOption(parser, kMechanics, "rate-per-min", 4.0, 60.0);
        if (!rate_perMin)
            return tl::unexpected(rate_perMin.error());
        healthy.pattern.rate = perMinute(*rate_perMin);
    }
    QJsonObject object = mechanicsTable(healthy);
    object[QStringLiteral("schema")] = QStringLiteral("carina.mechanics/1");
    return object;
}

Result<QJsonObject> runMechanics(const QStringList& arguments)
{
    const QString waveform = QStringLiteral("waveform");
    QCommandLineParser parser;
    addValueOptions(parser, {"waveform", "inspiratory-flow-l-per-min", "patient", "rate-per-min"});
    addPositionOption(parser);
    if (const auto parsed = parseOptions(parser, kMechanics, arguments); !parsed)
        return tl::unexpected(parsed.error());
    const bool hasFlow = parser.isSet(QStringLiteral("inspiratory-flow-l-per-min"));
    if (!parser.isSet(waveform) && !hasFlow)
        return describeTable(parser);
    if (!parser.isSet(waveform) || parser.isSet(QStringLiteral("patient"))
        || parser.isSet(QStringLiteral("rate-per-min")) || parser.isSet(QStringLiteral("position")))
        return fail(Errc::OutOfRange, "mechanics takes --patient, --rate-per-min and --position "
                                      "alone, or --waveform with or without a flow.");
    const auto assumed_lPerMin =
        hasFlow ? numberOption(parser, kMechanics, "inspiratory-flow-l-per-min", 1.0, 200.0)
                : Result<double>{kUsualFlow_lPerMin};
    return assumed_lPerMin.and_then([&](double flow_lPerMin) {
        return describeWaveform(parser.value(waveform), flow_lPerMin);
    });
}

} // namespace

Command mechanicsCommand() { return {"mechanics", kMechanicsHelp, runMechanics}; }

} // namespace carina::lab
