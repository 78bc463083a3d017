#include "ui/scene/throat_contents.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_source.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"
#include "ui/scene/scene_parts.h"
#include "ui/scene/station_scene.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/scene/view/scene_view.h"

#include <algorithm>
#include <numbers>
#include <set>

namespace carina::throat_contents_test
{
namespace
{

using test::FakeSessionNode;
using test::soon;
using enum AirwayEventKind;

constexpr double kSmall_m = 1e-12;
constexpr std::chrono::seconds kDrawn{60}; ///< by a loaded software renderer
constexpr std::size_t kSomePixels = 20;

const PatientModel& adult()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::Adult).value()).value();
    return *made;
}

/// Events that lie in a throat, in the adult.
std::vector<ThroatContent> contentsOf(const AirwayEvents& events)
{
    auto scope = Laryngoscopy::of(adult(), bladeOf(kUsualBlade)).value();
    scope.changeAirway(events);
    return scope.contentsAt(adult().throat(std::nullopt), {});
}

} // namespace

class TestThroatContents : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void hasAFigureForEachFluidAndPlace()
    {
        const auto contents = contentsOf({{Blood, 0.5}, {Vomit, 1.0}, {ForeignBody, 1.0}});
        const std::vector<SceneFigure> figures = contentFigures(drawnContents(contents));
        QCOMPARE(figures.size(), std::size_t{5}); // the fluids in the vallecula, too
        std::set<std::string> bodies;
        std::set<std::uint16_t> ids;
        for (const SceneFigure& figure : figures) {
            QVERIFY(figure.name.isEmpty());
            QCOMPARE(figure.parts.size(), std::size_t{1});
            QCOMPARE(figure.parts.front().body, figure.body);
            bodies.insert(figure.body);
            ids.insert(figure.parts.front().id);
        }
        QCOMPARE(bodies.size(), figures.size());
        QCOMPARE(ids.size(), figures.size());
    }

    /// A fluid that rises needs another one each 2 mm.
    void needsOtherFiguresOnlyAsAFluidRises()
    {
        const auto drawn = [](double severity) {
            return drawnContents(contentsOf({{Blood, severity}}));
        };
        QVERIFY(drawn(0.50) == drawn(0.52));
        QVERIFY(drawn(0.50) != drawn(0.70));
        QVERIFY(drawnContents({}).empty());
    }

    /// A quarter about z, and twice as large.
    void goesWithAPatientThatIsMoved()
    {
        const std::vector<ThroatContent> contents = contentsOf({{Blood, 0.5}});
        StationMoment moment;
        SceneFrame here = sceneFrame(moment, adult().lungs().field());
        addContents(here, contents);
        const Quat quarter{Eigen::AngleAxisd{std::numbers::pi / 2.0, Vec3::UnitZ()}};
        moment.patient.emplace().acted = {RigidTransform{quarter, Vec3{0.1, 0.0, 0.0}}, 2.0};
        SceneFrame there = sceneFrame(moment, adult().lungs().field());
        addContents(there, contents);
        const Vec3 p_F{0.01, 0.02, 0.03};
        for (const ThroatContent& content : contents) {
            const std::string body = bodyOfContent(content.kind, content.place);
            const Vec3 p_A = here.bodies.at(body).at(p_F);
            QVERIFY((p_A - (content.p_AF + content.size * p_F)).norm() < kSmall_m);
            const Vec3 moved{0.1 - 2.0 * p_A.y(), 2.0 * p_A.x(), 2.0 * p_A.z()};
            QVERIFY((there.bodies.at(body).at(p_F) - moved).norm() < kSmall_m);
        }
    }

    /// In the picture of the whole patient, from one side or another, without a laryngoscope.
    void isSeenInTheWholePatient()
    {
        if (!graphicsDriver())
            QSKIP("no OpenGL 3.3");
        FakeSessionNode node{FakeSessionNode::kTrainee};
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        StationView view{node, FakeSessionNode::kStation, adult().lungs()};
        SceneView picture;
        StationScene scene{picture, adult(), view};
        picture.resize(640, 480);
        picture.show();
        QVERIFY(soon([&] { return picture.statistics().frames > 2; }, kDrawn));
        QVERIFY(!picture.frame().bodies.contains("blood"));
        node.decide(fact::AirwayEventsSet{{{Blood, 1.0}}, {}});
        QVERIFY(soon([&] { return picture.frame().bodies.contains("blood"); }, kDrawn));
        QVERIFY(picture.frame().bodies.contains("blood in the vallecula"));
        QVERIFY(isSeen(picture, "blood"));
        node.decide(fact::AirwayEventsSet{{}, {}});
        QVERIFY(soon([&] { return !picture.frame().bodies.contains("blood"); }, kDrawn));
    }

private:
    static bool isSeen(SceneView& picture, const char* body)
    {
        const auto figures = contentFigures(drawnContents(contentsOf({{Blood, 1.0}})));
        const auto figure = std::ranges::find(figures, std::string{body}, &SceneFigure::body);
        for (const ViewPreset preset :
             {ViewPreset::Right, ViewPreset::Front, ViewPreset::Trainee}) {
            picture.showFrom(preset);
            const std::size_t next = picture.statistics().frames + 2;
            if (!soon([&] { return picture.statistics().frames >= next; }, kDrawn))
                return false;
            const auto pixels = picture.visiblePixels();
            const auto found = pixels.find(figure->parts.front().id);
            if (found != pixels.end() && found->second > kSomePixels)
                return true;
        }
        return false;
    }
};

CARINA_SCREEN_TEST(TestThroatContents)

} // namespace carina::throat_contents_test

#include "tst_throat_contents.moc"
