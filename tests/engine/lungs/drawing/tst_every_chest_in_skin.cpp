#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/anatomy/patient/patient_name.h"
#include "tests/engine/lungs/drawing/chest_in_skin.h"
#include "tests/support/test_class.h"

#include <map>

namespace carina::every_chest_in_skin_test
{

using namespace carina::test;

namespace
{

constexpr std::array kSeverities{0.3, 0.6, 0.9, 1.0};
constexpr std::array kRates_perMin{12.0, 40.0};
constexpr std::array kModes{VentilationMode::Spontaneous, VentilationMode::VolumeControl,
                            VentilationMode::PressureControl};

/// Each side that a condition can have.
std::vector<ConditionSide> sidesOf(ConditionKind kind)
{
    if (kind == ConditionKind::Normal)
        return {ConditionSide::Both};
    if (kind == ConditionKind::MainstemIntubation)
        return {ConditionSide::Right, ConditionSide::Left};
    return {ConditionSide::Both, ConditionSide::Right, ConditionSide::Left};
}

/// Ten minutes take ten times as long to compute: at the ends of the severities they are enough.
bool isSeenAfterTenMinutes(ConditionKind kind, double severity)
{
    return developsForMinutes(kind)
           && (severity == kSeverities.front() || severity == kSeverities.back());
}

} // namespace

/// Every condition, severity, side, ventilator and position, after a minute, and where gas goes on
/// for longer after ten, too: lungs and diaphragm stay within the skin and whole.
class TestEveryChestInSkin : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void staysInTheSkinAndWhole_data();
    void staysInTheSkinAndWhole();
};

void TestEveryChestInSkin::staysInTheSkinAndWhole_data()
{
    QTest::addColumn<QString>("patient");
    QTest::addColumn<BodyPosition>("position");
    QTest::addColumn<ConditionKind>("kind");
    constexpr std::array kPositions{"supine", "sitting", "prone", "on the right side",
                                    "on the left side"};
    for (const char* patient : {"adult", "child"})
        for (std::size_t position = 0; position < kPositions.size(); ++position)
            for (const ConditionKind kind : kConditionKinds)
                QTest::addRow("%s, %s, condition %d", patient, kPositions[position], int(kind))
                    << QString::fromLatin1(patient) << static_cast<BodyPosition>(position) << kind;
    QTest::addRow("the fullest lungs for their size at rest")
        << QStringLiteral("45 years, 182 cm, man, obese") << BodyPosition::Sitting
        << ConditionKind::Copd;
}

void TestEveryChestInSkin::staysInTheSkinAndWhole()
{
    QFETCH(QString, patient);
    QFETCH(BodyPosition, position);
    QFETCH(ConditionKind, kind);
    static std::map<QString, SkinnedChest> chests;
    const PatientParameters parameters = patientFromWords(patient.toStdString()).value();
    const SkinnedChest& chest = chests.try_emplace(patient, parameters).first->second;
    RespiratorySettings settings;
    settings.build = buildOf(dimensionsFor(parameters).value());
    settings.position = position;
    const BreathingPattern quiet = restingPattern(settings.build);
    for (const ConditionSide side : sidesOf(kind)) {
        for (const double severity : kSeverities) {
            for (const VentilationMode mode : kModes) {
                for (const Volume tidalVolume :
                     {quiet.tidalVolume, largestTidalVolume(settings.build)}) {
                    for (const double rate_perMin : kRates_perMin) {
                        if (kind != ConditionKind::Normal)
                            settings.conditions = {LungCondition{kind, severity, side}};
                        settings.ventilator.mode = mode;
                        settings.pattern = quiet;
                        settings.pattern.tidalVolume = tidalVolume;
                        settings.pattern.rate = perMinute(rate_perMin);
                        const QString what =
                            QStringLiteral("severity %1, side %2, mode %3, %4 ml, %5 /min")
                                .arg(severity)
                                .arg(int(side))
                                .arg(int(mode))
                                .arg(inMillilitres(tidalVolume))
                                .arg(rate_perMin);
                        verifyInSkin(chest, settings, what);
                        if (isSeenAfterTenMinutes(kind, severity))
                            verifyInSkin(chest, settings,
                                         what + QStringLiteral(", after ten minutes"),
                                         kTenMinutes_s);
                    }
                }
            }
        }
    }
}

CARINA_TEST(TestEveryChestInSkin)

} // namespace carina::every_chest_in_skin_test

#include "tst_every_chest_in_skin.moc"
