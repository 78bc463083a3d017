#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_source.h"
#include "models/vitals/stethoscope.h"
#include "tests/support/test_class.h"

namespace carina::stethoscope_test
{
namespace
{

const PatientModel& child()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return *made;
}

Box boxOf(PartRole role)
{
    Box box;
    for (const PatientSurface& surface : child().surfaces())
        if (surface.description.role == role)
            box.include(boundsOf(*surface.levels.front()));
    return box;
}

Box boxOf(Side side)
{
    Box box;
    for (const PatientSurface& surface : child().surfaces())
        if (lungSide(surface.description.role) == side)
            box.include(boundsOf(*surface.levels.front()));
    return box;
}

/// Where a stethoscope that comes from the front first touches the skin before a point.
Vec3 inFrontOf(const Vec3& p_A)
{
    const ChestSites sites{child()};
    Vec3 tip = p_A;
    for (tip.y() = -0.5; tip.y() < p_A.y(); tip.y() += 0.001)
        if (sites.heardAt(tip) != AuscultationGains{})
            break;
    return tip;
}

StationMoment withStylusAt(const Vec3& p_A, Validity validity = Validity::Tracked)
{
    StationMoment moment;
    PersonPose stylus;
    stylus.kind = ObjectKind::Stylus;
    stylus.pose.X_FO = RigidTransform::translation(p_A);
    stylus.pose.validity = validity;
    moment.people = {stylus};
    return moment;
}

} // namespace

class TestStethoscope : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hearsTheLungBeneath()
    {
        const ChestSites sites{child()};
        const auto right = sites.heardAt(inFrontOf(boxOf(Side::Right).centre()));
        QVERIFY(right.right > 0.9 && right.left < 0.3);
        const auto left = sites.heardAt(inFrontOf(boxOf(Side::Left).centre()));
        QVERIFY(left.left > 0.9 && left.right < 0.3);
    }

    void hearsTheStomachBelowTheLeftLung()
    {
        const Box left = boxOf(Side::Left);
        const Vec3 below{left.centre().x(), left.centre().y(),
                         left.min.z() - 0.1 * left.size().z()};
        const auto heard = ChestSites{child()}.heardAt(inFrontOf(below));
        QVERIFY(heard.stomach > 0.9);
        QVERIFY(heard.right < 0.3 && heard.left < heard.stomach);
    }

    void hearsTheHeartWhereItIs()
    {
        const Box heart = boxOf(PartRole::Heart);
        if (heart.empty())
            QSKIP("this patient is made without a heart");
        const auto heard = ChestSites{child()}.heardAt(inFrontOf(heart.centre()));
        QVERIFY(heard.heart > 0.9);
    }

    /// On the skin, and nothing but what is beneath.
    void listensForBreathingWhereItIsHeard()
    {
        const ChestSites sites{child()};
        const std::vector<Vec3> places = sites.placesToListen();
        QCOMPARE(places.size(), std::size_t{3});
        const AuscultationGains stomach = sites.heardAt(places[0]);
        QVERIFY(stomach.stomach > 0.99);
        const AuscultationGains left = sites.heardAt(places[1]);
        QVERIFY(left.left > 0.99 && left.right < 0.3);
        const AuscultationGains right = sites.heardAt(places[2]);
        QVERIFY(right.right > 0.99 && right.left < 0.3);
        QVERIFY(places[0].x() > 0.0 && places[0].z() < boxOf(Side::Left).min.z()); // left, below it
        QVERIFY(boxOf(Side::Left).min.x() < places[1].x() && places[2].x() < 0.0);
        for (const Vec3& p_A : places) {
            // That is first heard kAuscultationContact before the skin; a bell goes on in steps.
            const double on_m = p_A.y() - inFrontOf(p_A + 0.1 * Vec3::UnitY()).y();
            QVERIFY2(on_m > 0.0 && on_m < 0.025, qPrintable(QString::number(on_m)));
        }
    }

    void hearsNothingOffTheChest()
    {
        Vec3 before = inFrontOf(boxOf(Side::Right).centre());
        before.y() -= 0.05;
        QCOMPARE(ChestSites{child()}.heardAt(before), AuscultationGains{});
    }

    void followsTheStylusesThatAreSeen()
    {
        Stethoscope stethoscope;
        QVERIFY(!stethoscope.heard(child(), StationMoment{}));
        const Vec3 right = inFrontOf(boxOf(Side::Right).centre());
        const auto heard = stethoscope.heard(child(), withStylusAt(right));
        QVERIFY(heard && *heard == ChestSites{child()}.heardAt(right));
        QVERIFY(!stethoscope.heard(child(), withStylusAt(right, Validity::Lost)));
        StationMoment two = withStylusAt(right);
        two.people.push_back(withStylusAt(right - Vec3{0.0, 0.3, 0.0}).people.front());
        QVERIFY(*stethoscope.heard(child(), two) == *heard); // the other is in the air
    }
};

CARINA_TEST(TestStethoscope)

} // namespace carina::stethoscope_test

#include "tst_stethoscope.moc"
