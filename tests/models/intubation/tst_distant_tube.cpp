#include "models/intubation/distant_tube.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/net/objects/remote_object.h"
#include "models/patient/patient_source.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::distant_tube_test
{
namespace
{

constexpr SessionTime kNow{std::chrono::seconds{100}};

const PatientModel& child()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return *made;
}

TissueAround still()
{
    return {[](const Vec3& p_A, AirwayTissue) { return p_A; }, {}};
}

/// The tube of another, which is seen, and has this form.
StationMoment momentOf(const std::optional<StreamShape>& shape)
{
    StreamCpo cpo;
    cpo.sequence = 1;
    cpo.time = kNow;
    cpo.X_AO = child().tube().X_AE;
    cpo.shape = shape;
    const auto poses = std::make_shared<RemoteObject>();
    poses->take(cpo, kNow);
    StationMoment moment;
    moment.time = kNow;
    moment.tube = poses->at(kNow);
    moment.tubePoses = poses;
    moment.tubeShape = poses->shapeAt(kNow);
    return moment;
}

} // namespace

class TestDistantTube : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void liesAsItsPoseHasItWhereNoFormIsSent()
    {
        DistantTube tube;
        tube.lieIn(child());
        const TubeInAirway lies = tube.at(momentOf(std::nullopt), still());
        QVERIFY(lies.p_E.empty());
        QCOMPARE(lies.drawing, TubeDrawing::AsMeasured);
    }

    /// Also of what is no tube at all.
    void hasTheFormThatWasSentWhereItHasNoRod_data()
    {
        QTest::addColumn<double>("length");
        QTest::addColumn<double>("atRest");
        QTest::newRow("lumen not measured yet") << 0.25 << 7.0;
        QTest::newRow("too short") << 1e-5 << 7.0;
        QTest::newRow("too long") << 0.65 << 7.0;
        QTest::newRow("too curved") << 0.25 << -65.0;
    }

    void hasTheFormThatWasSentWhereItHasNoRod()
    {
        QFETCH(double, length);
        QFETCH(double, atRest);
        const StreamShape shape{kNow, length, 0.009, {atRest, atRest}, {1.0, -2.0, 0.5}};
        DistantTube tube;
        tube.lieIn(child());
        StationMoment moment = momentOf(shape);
        const TubeInAirway lies = tube.at(moment, still());
        QVERIFY(std::ranges::equal(lies.p_E, lineOf(shape, child().ownTube())));
        QCOMPARE(lies.drawing, TubeDrawing::InAirway);
        moment.tubeIsApart = true;
        QCOMPARE(tube.at(moment, still()).drawing, TubeDrawing::Apart);
    }
};

CARINA_TEST(TestDistantTube)

} // namespace carina::distant_tube_test

#include "tst_distant_tube.moc"
