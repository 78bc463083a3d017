#include "engine/anatomy/patient/patient_dimensions.h"
#include "tests/engine/lungs/drawing/chest_in_skin.h"
#include "tests/support/test_class.h"

namespace carina::chest_in_skin_test
{

using namespace carina::test;

namespace
{

const SkinnedChest& adult()
{
    static const SkinnedChest chest{parametersOf(BuiltinPatient::Adult)};
    return chest;
}

RespiratorySettings settingsOf(BuiltinPatient patient, const LungCondition& condition,
                               VentilationMode mode)
{
    RespiratorySettings settings;
    settings.build = buildOf(dimensionsFor(parametersOf(patient)).value());
    settings.pattern = restingPattern(settings.build);
    if (condition.kind != ConditionKind::Normal)
        settings.conditions = {condition};
    settings.ventilator.mode = mode;
    return settings;
}

RespiratorySettings adultWith(const LungCondition& condition, VentilationMode mode)
{
    return settingsOf(BuiltinPatient::Adult, condition, mode);
}

} // namespace

/// What is drawn of diseased lungs and of the diaphragm, beside the skin.
class TestChestInSkin : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void staysInTheSkinAndWhole_data();
    void staysInTheSkinAndWhole();
    void keepsAChildsTrappedGasInTheSkin();
    void movesAsideUnderTension_data();
    void movesAsideUnderTension();
};

void TestChestInSkin::staysInTheSkinAndWhole_data()
{
    QTest::addColumn<LungCondition>("condition");
    QTest::addColumn<VentilationMode>("mode");
    QTest::addColumn<BodyPosition>("position");
    QTest::addColumn<bool>("isDeep");
    using enum ConditionKind;
    using enum VentilationMode;
    using enum BodyPosition;
    constexpr auto kRight = ConditionSide::Right;
    constexpr auto kLeft = ConditionSide::Left;
    constexpr auto kBoth = ConditionSide::Both;
    QTest::newRow("health") << LungCondition{} << Spontaneous << Supine << false;
    QTest::newRow("health, the deepest breath")
        << LungCondition{} << Spontaneous << Sitting << true;
    QTest::newRow("tension on the right, ventilated")
        << LungCondition{TensionPneumothorax, 1.0, kRight} << VolumeControl << Supine << false;
    QTest::newRow("tension on the left, deep, on the right side")
        << LungCondition{TensionPneumothorax, 1.0, kLeft} << VolumeControl << RightLateral << true;
    QTest::newRow("tension on both sides")
        << LungCondition{TensionPneumothorax, 1.0, kBoth} << VolumeControl << Supine << false;
    QTest::newRow("COPD, prone, deep")
        << LungCondition{Copd, 1.0, kBoth} << VolumeControl << Prone << true;
    QTest::newRow("atelectasis, sitting, deep")
        << LungCondition{Atelectasis, 1.0, kRight} << Spontaneous << Sitting << true;
}

void TestChestInSkin::staysInTheSkinAndWhole()
{
    QFETCH(LungCondition, condition);
    QFETCH(VentilationMode, mode);
    QFETCH(BodyPosition, position);
    QFETCH(bool, isDeep);
    RespiratorySettings settings = adultWith(condition, mode);
    settings.position = position;
    if (isDeep)
        settings.pattern.tidalVolume = largestTidalVolume(settings.build);
    verifyInSkin(adult(), settings, QString::fromLatin1(QTest::currentDataTag()));
}

/// Lungs that hold 3.4 times as much as at rest.
void TestChestInSkin::keepsAChildsTrappedGasInTheSkin()
{
    const BuiltinPatient child = BuiltinPatient::TwelveYears;
    RespiratorySettings settings = settingsOf(
        child, {ConditionKind::Copd, 1.0, ConditionSide::Both}, VentilationMode::VolumeControl);
    settings.position = BodyPosition::Sitting;
    settings.pattern.tidalVolume = largestTidalVolume(settings.build);
    settings.pattern.rate = perMinute(12.0);
    verifyInSkin(SkinnedChest{parametersOf(child)}, settings, QStringLiteral("COPD"));
}

void TestChestInSkin::movesAsideUnderTension_data()
{
    QTest::addColumn<ConditionSide>("side");
    QTest::addColumn<VentilationMode>("mode");
    using enum VentilationMode;
    QTest::newRow("right, breathing alone") << ConditionSide::Right << Spontaneous;
    QTest::newRow("left, breathing alone") << ConditionSide::Left << Spontaneous;
    QTest::newRow("right, ventilated") << ConditionSide::Right << VolumeControl;
    QTest::newRow("left, ventilated") << ConditionSide::Left << VolumeControl;
}

/// At the end of expiration, within a minute: the trachea by half of its width at least, to the
/// other side, and the half of the diaphragm beneath the gas down. Where the patient breathes alone
/// it is farther down than the other half; a ventilator that has filled the chest lowers both as
/// far as they are drawn, which the shape of each half makes a little different.
void TestChestInSkin::movesAsideUnderTension()
{
    constexpr double kSeen_mm = 8.0;
    QFETCH(ConditionSide, side);
    QFETCH(VentilationMode, mode);
    const RespiratorySettings settings =
        adultWith({ConditionKind::TensionPneumothorax, 1.0, side}, mode);
    const ChestShape shape = endsOfSettledBreath(settings)[0];
    const ChestPose pose = drawnPose(adult().lungs(), shape, adult().level());
    const bool isRight = side == ConditionSide::Right;
    const double aside_mm = 1e3 * (isRight ? 1.0 : -1.0) * adult().carinaMoved(pose).x();
    const double most_mm = 1e3 * kDrawnShift / adult().lungs().field().frame().perMetre.u;
    const double asked_mm = std::min(std::abs(inMillimetres(shape.mediastinalShift)), most_mm);
    QVERIFY2(aside_mm > kSeen_mm && aside_mm > 0.95 * asked_mm,
             qPrintable(QStringLiteral("%1 of %2 mm").arg(aside_mm).arg(asked_mm)));
    const Length beneath = adult().descent(pose, isRight ? Side::Right : Side::Left);
    const Length beside = adult().descent(pose, isRight ? Side::Left : Side::Right);
    const double times = mode == VentilationMode::Spontaneous ? 1.5 : 0.8;
    QVERIFY2(
        inMillimetres(beneath) > kSeen_mm && beneath > times * beside,
        qPrintable(
            QStringLiteral("%1 and %2 mm").arg(inMillimetres(beneath)).arg(inMillimetres(beside))));
}

CARINA_TEST(TestChestInSkin)

} // namespace carina::chest_in_skin_test

#include "tst_chest_in_skin.moc"
