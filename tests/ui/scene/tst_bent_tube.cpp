#include "engine/anatomy/patient/builtin_patient.h"
#include "models/intubation/sent_shape.h"
#include "models/patient/patient_source.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"
#include "ui/scene/scene_parts.h"
#include "ui/scene/station_scene.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/scene/view/scene_view.h"

namespace carina::bent_tube_test
{
namespace
{

using test::FakeSessionNode;
using test::soon;

constexpr std::chrono::seconds kDrawn{60}; ///< by a loaded software renderer
constexpr double kAside = 0.03;            ///< metres of the tip
constexpr double kLonger_m = 4e-3;         ///< is the line that is aside, at most
constexpr double kArc = 0.2;               ///< metres of a tube that was sent
constexpr double kExact_m = 1e-6;

const PatientModel& adult()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::Adult).value()).value();
    return *made;
}

/// The tube with its tip aside.
std::vector<Vec3> bentLine()
{
    std::vector<Vec3> line = adult().tube().p_E_centre;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double share = double(i) / double(line.size() - 1);
        line[i].x() += kAside * share * share;
    }
    return line;
}

} // namespace

class TestBentTube : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    /// And that the shapes are apart, by an outline and for the notice.
    void isDrawnAsItLiesInTheAirway()
    {
        if (!graphicsDriver())
            QSKIP("no OpenGL 3.3");
        FakeSessionNode node{FakeSessionNode::kTrainee};
        const ObjectPoses own{.at = [](ObjectKind kind, SessionTime t) {
            return kind == ObjectKind::Tube
                       ? std::optional{PoseSample{.time = t, .X_FO = adult().tube().X_AE}}
                       : std::nullopt;
        }};
        StationView view{node, FakeSessionNode::kStation, adult().lungs(), own};
        SceneView picture;
        StationScene scene{picture, adult(), view};
        TubeInAirway lies;
        scene.bendTubeBy([&lies](const StationMoment&, const TissueAround&) { return lies; });
        picture.resize(320, 240);
        picture.show();
        QVERIFY(soon([&] { return picture.frame().bodies.contains(kTubeBody); }, kDrawn));
        QVERIFY(picture.frame().bentAlong.empty());
        QVERIFY(picture.frame().bentInPlace.contains(kTubeBody));
        lies = {bentLine(), TubeDrawing::Apart};
        QVERIFY(soon([&] { return picture.frame().bentAlong.contains(kTubeBody); }, kDrawn));
        QVERIFY(!picture.frame().bentInPlace.contains(kTubeBody));
        const Vec3& p_E_tip = adult().tube().p_E_tip;
        const Vec3 drawn = picture.frame().bentAlong.at(kTubeBody)->taken(p_E_tip);
        QVERIFY((drawn - (p_E_tip + kAside * Vec3::UnitX())).norm() < kLonger_m);
        const std::string outline = measuredTubeFigure(adult()).body;
        QVERIFY(picture.frame().bodies.contains(outline));
        QCOMPARE(scene.moment().tubeDrawing, TubeDrawing::Apart);
        lies = {};
        QVERIFY(soon([&] { return picture.frame().bentAlong.empty(); }, kDrawn));
        QVERIFY(!picture.frame().bodies.contains(outline));
        QCOMPARE(scene.moment().tubeDrawing, TubeDrawing::AsMeasured);
    }

    /// And goes with the tube; that of a tube that is not seen is not drawn.
    void cuffIsDrawnFullWhileItIsInflated()
    {
        if (!graphicsDriver())
            QSKIP("no OpenGL 3.3");
        FakeSessionNode node{FakeSessionNode::kTrainee};
        const StationView view{node, FakeSessionNode::kStation, adult().lungs(), {}};
        SceneView picture;
        StationScene scene{picture, adult(), view};
        std::vector<Vec3> p_E = adult().tube().p_E_centre;
        scene.bendTubeBy([&](const StationMoment&, const TissueAround&) {
            return TubeInAirway{p_E, TubeDrawing::InAirway};
        });
        StationMoment moment = view.at(*node.now(), 0);
        moment.tube = PoseSample{.X_FO = adult().tube().X_AE};
        QVERIFY(!sceneFrame(moment, ChestField{}).bodies.contains(kCuffBody));
        moment.isCuffInflated = true;
        SceneFrame frame = sceneFrame(moment, ChestField{});
        QVERIFY(scene.bendTubeAtWork(frame, moment) == TubeDrawing::InAirway);
        QVERIFY(frame.bodies.contains(kCuffBody));
        QCOMPARE(frame.bentAlong.at(kCuffBody), frame.bentAlong.at(kTubeBody));
        moment.tube.reset();
        QVERIFY(!sceneFrame(moment, ChestField{}).bodies.contains(kCuffBody));
        const auto parts = sceneParts(adult());
        QCOMPARE(std::ranges::count(parts, std::string{kCuffBody}, &ScenePart::body), 1);
    }

    /// As its owner has it, and not as this program's own would lie; also one of another length.
    void ofAnotherIsDrawnAsItWasSent()
    {
        if (!graphicsDriver())
            QSKIP("no OpenGL 3.3");
        FakeSessionNode node{FakeSessionNode::kInstructor};
        StreamCpo cpo;
        cpo.object = FakeSessionNode::kTube;
        cpo.time = *node.now();
        cpo.X_AO = adult().tube().X_AE;
        cpo.shape = StreamShape{cpo.time, kArc, 0.01, {}, {0.0, 8.0}};
        node.takes(cpo);
        StationView view{node, FakeSessionNode::kStation, adult().lungs(), {}};
        SceneView picture;
        StationScene scene{picture, adult(), view};
        scene.bendTubeBy([](const StationMoment&, const TissueAround&) {
            return TubeInAirway{{}, TubeDrawing::Awaited};
        });
        SceneFrame frame = sceneFrame(view.at(cpo.time, 0), ChestField{});
        QCOMPARE(scene.bendTubeAtWork(frame, view.at(cpo.time, 0)), TubeDrawing::InAirway);
        const Vec3 p_E_tip = lineOf(*cpo.shape, adult().ownTube()).back();
        QVERIFY((frame.bentAlong.at(kTubeBody)->bent().back() - p_E_tip).norm() < kExact_m);
        const Vec3 drawn = frame.bentAlong.at(kTubeBody)->taken(adult().tube().p_E_centre.back());
        QVERIFY((drawn - p_E_tip).norm() < kExact_m);
    }
};

CARINA_SCREEN_TEST(TestBentTube)

} // namespace carina::bent_tube_test

#include "tst_bent_tube.moc"
