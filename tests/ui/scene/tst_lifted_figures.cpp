#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/support/test_class.h"
#include "ui/scene/lifted_figures.h"
#include "ui/scene/scene_parts.h"

#include <numbers>
#include <set>

namespace carina::lifted_figures_test
{
namespace
{

constexpr double kSmall_m = 1e-12;

LiftedObject lifted(std::uint16_t object, std::optional<OrganGroup> group,
                    const ActedPose& acted = {})
{
    return {.object = ObjectId{object},
            .owner = ParticipantId{2},
            .ownerName = "Tom",
            .group = group,
            .acted = acted};
}

ActedPose quarterAboutZ(const Vec3& way = Vec3::Zero(), double scale = 1.0)
{
    const Quat quarter{Eigen::AngleAxisd{std::numbers::pi / 2.0, Vec3::UnitZ()}};
    return {RigidTransform{quarter, way}, scale};
}

} // namespace

/// Where what is lifted out is drawn, of a child without heart and vessels.
class TestLiftedFigures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        Anatomy child = builtinPatient(BuiltinPatient::TwelveYears).value();
        std::erase_if(child.parts, [](const AnatomyPart& part) {
            return groupOf(part.role) == OrganGroup::Vessels;
        });
        m_patient = PatientModel::of(std::move(child), millimetres(6.0)).value();
    }

    /// Everything but the tube is of a group that it can be lifted out with.
    void everyPartOfThePatientIsOfAGroup()
    {
        for (const ScenePart& part : sceneParts(*m_patient))
            QCOMPARE(groupFromName(part.liftedWith).has_value(),
                     part.body != kTubeBody && part.body != kCuffBody);
    }

    void leavesWhatWasOnlyLiftedWhereItWas()
    {
        StationMoment moment;
        moment.patient.emplace().acted = quarterAboutZ({0.0, 0.1, 0.0}, 2.0);
        moment.lifted = {lifted(4, OrganGroup::Lungs)};
        const SceneFrame frame = frameOf(moment);
        QVERIFY((frame.lifted.at("lungs").at(kPoint) - kPoint).norm() < kSmall_m);
        QCOMPARE(frame.lifted.size(), std::size_t{1});
    }

    /// (x, y, z) from the centre goes to 2 (-y, x, z) from it, and 3 cm along x.
    void turnsAndScalesAGroupAboutItsCentre()
    {
        const Vec3 centre = m_patient->centreOf(OrganGroup::Lungs).value();
        StationMoment moment;
        moment.lifted = {lifted(4, OrganGroup::Lungs, quarterAboutZ({0.03, 0.0, 0.0}, 2.0))};
        const PlacedBody motion = frameOf(moment).lifted.at("lungs");
        const Vec3 away = centre + Vec3{0.03, 0.0, 0.0};
        QVERIFY((motion.at(centre) - away).norm() < kSmall_m);
        QVERIFY((motion.at(centre + kPoint) - away
                 - Vec3{-2.0 * kPoint.y(), 2.0 * kPoint.x(), 2.0 * kPoint.z()})
                    .norm()
                < kSmall_m);
    }

    /// Its way is told in the frame of the patient, which is turned by a quarter: along y in A.
    void goesWithThePatientThatItIsLiftedFrom()
    {
        const Vec3 centre = m_patient->centreOf(OrganGroup::Airway).value();
        StationMoment moment;
        moment.patient.emplace().acted = quarterAboutZ({}, 2.0);
        moment.lifted = {lifted(3, OrganGroup::Airway, {RigidTransform::translation({0.1, 0, 0})})};
        const SceneFrame frame = frameOf(moment);
        const Vec3 inPlace = frame.bodies.at(kPatientBody).at(centre);
        QVERIFY((frame.lifted.at("airway").at(inPlace) - inPlace - Vec3(0.0, 0.2, 0.0)).norm()
                < kSmall_m);
    }

    void drawsTheSecondTubeBesideThePatientWhileItIsOut()
    {
        StationMoment moment;
        QVERIFY(liftedFigures(drawnLifts(moment, *m_patient), *m_patient).empty());
        moment.lifted = {lifted(9, std::nullopt)};
        const auto figures = liftedFigures(drawnLifts(moment, *m_patient), *m_patient);
        QCOMPARE(figures.size(), std::size_t{1});
        QVERIFY(!figures.front().parts.empty());
        const PlacedBody in = frameOf(moment).bodies.at(figures.front().parts.front().body);
        QVERIFY(in.X_AF.translation().x() > m_patient->tube().X_AE.translation().x() + 0.1);
        // It turns about its middle.
        moment.lifted = {lifted(9, std::nullopt, quarterAboutZ())};
        const PlacedBody turned = frameOf(moment).bodies.at(figures.front().parts.front().body);
        const Vec3 middle = m_patient->tubeCentre();
        QVERIFY((turned.at(middle) - in.at(middle)).norm() < kSmall_m);
        QVERIFY((turned.at(Vec3::Zero()) - in.at(Vec3::Zero())).norm() > 0.005);
    }

    void hasIdsOfItsOwn()
    {
        StationMoment moment;
        moment.lifted = {lifted(9, std::nullopt), lifted(10, std::nullopt)};
        std::set<std::uint16_t> ids;
        for (const ScenePart& part : sceneParts(*m_patient))
            ids.insert(part.id);
        for (const SceneFigure& figure : liftedFigures(drawnLifts(moment, *m_patient), *m_patient))
            for (const ScenePart& part : figure.parts)
                QVERIFY(ids.insert(part.id).second);
    }

    void namesWhatIsLiftedWithWhoHasIt()
    {
        StationMoment moment;
        moment.lifted = {lifted(4, OrganGroup::Lungs), lifted(9, std::nullopt)};
        const auto lifts = drawnLifts(moment, *m_patient);
        QCOMPARE(lifts.at(0).name, QStringLiteral("Lungs (Tom)"));
        QCOMPARE(lifts.at(1).name, QStringLiteral("Second tube (Tom)"));
    }

    /// As a patient without a heart and vessels.
    void drawsNothingOfAGroupThatThePatientLacks()
    {
        QVERIFY(!m_patient->centreOf(OrganGroup::Vessels));
        StationMoment moment;
        moment.lifted = {lifted(6, OrganGroup::Vessels)};
        const SceneFrame frame = frameOf(moment);
        QVERIFY(frame.lifted.empty() && liftedIn(frame, moment).empty());
        QVERIFY(drawnLifts(moment, *m_patient).empty());
    }

    void tellsWhatAFrameDrawsWhere()
    {
        StationMoment moment;
        moment.lifted = {lifted(4, OrganGroup::Lungs, quarterAboutZ({0.1, 0.0, 0.0}, 2.0)),
                         lifted(9, std::nullopt)};
        const auto told = liftedIn(frameOf(moment), moment);
        QCOMPARE(told.size(), std::size_t{2});
        const Vec3 centre = m_patient->centreOf(OrganGroup::Lungs).value();
        QVERIFY((told[0].place.X_AF.translation() - centre - Vec3(0.1, 0.0, 0.0)).norm()
                < kSmall_m);
        QCOMPARE(told[0].place.scale, 2.0);
        QVERIFY(told[0].group == OrganGroup::Lungs && !told[1].group);
    }

private:
    [[nodiscard]] SceneFrame frameOf(const StationMoment& moment) const
    {
        SceneFrame frame = sceneFrame(moment, ChestField{});
        addLifted(frame, moment, *m_patient);
        return frame;
    }

    static inline const Vec3 kPoint{0.01, -0.02, 0.3};
    std::optional<PatientModel> m_patient;
};

CARINA_TEST(TestLiftedFigures)

} // namespace carina::lifted_figures_test

#include "tst_lifted_figures.moc"
