#include "ui/panels/airway/laryngoscope_panel.h"

#include "ui/panels/airway/scope_canvas.h"
#include "ui/panels/airway/scope_window.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_source.h"
#include "tests/models/fake_session_node.h"
#include "tests/models/lacking_patient.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"
#include "ui/scene/station_scene.h"
#include "widgets/inside_window.h"
#include "widgets/scene/view/graphics.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QStandardItemModel>
#include <QToolButton>

namespace carina::laryngoscope_panel_test
{
namespace
{

using test::FakeSessionNode;
using test::soon;

constexpr std::chrono::seconds kDrawn{60}; ///< by a loaded software renderer

/// With the mouth shut in the surfaces, as for the pictures of docs/laryngoscopy.md.
const PatientModel& adult()
{
    static const SharedPatientModel made =
        patientOf(patientFor(parametersOf(BuiltinPatient::Adult), Posture::Rest).value()).value();
    return *made;
}

/// With the mouth held open in the surfaces, as the programs have it.
const PatientModel& heldOpen()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::Adult).value()).value();
    return *made;
}

LaryngoscopyPose poseIn(LaryngoscopyStep step, const PatientModel& patient = adult())
{
    return Laryngoscopy::of(patient, bladeOf(BladeKind::Macintosh3))->pose(step, kUsualLift);
}

SceneView* pictureOf(const LaryngoscopePanel& panel)
{
    return panel.findChild<SceneView*>(QStringLiteral("laryngoscopePicture"));
}

/// A trainee whose own tracker has blade and jaw where a laryngoscopy has them, and the panel.
struct Desk {
    explicit Desk(const PatientModel& lying = adult()) : who{lying}
    {
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        node.decide(fact::ObjectShared{
            {}, FakeSessionNode::kTrainee, ObjectKind::Laryngoscope, "Laryngoscope"});
        panel.setStation(scene);
        panel.resize(440, 420);
        panel.show();
    }
    /// The picture is made once the panel is seen. Its edges are drawn alike every time.
    [[nodiscard]] bool hasPicture() const
    {
        if (!soon([&] { return pictureOf(panel) != nullptr; }, kDrawn))
            return false;
        picture().setFixedQuality(PictureQuality::Quick);
        return true;
    }

    const PatientModel& who;
    std::optional<LaryngoscopyPose> pose; ///< nothing: never seen
    Validity validity = Validity::Tracked;
    FakeSessionNode node{FakeSessionNode::kTrainee};
    StationView view{node,
                     FakeSessionNode::kStation,
                     who.lungs(),
                     {.at = [this](ObjectKind kind, SessionTime t) { return poseOf(kind, t); }}};
    SceneView patient; ///< is not shown
    StationScene scene{patient, who, view};
    LaryngoscopePanel panel;

    std::optional<PoseSample> poseOf(ObjectKind kind, SessionTime t) const
    {
        if (!pose || (kind != ObjectKind::Laryngoscope && kind != ObjectKind::Jaw))
            return std::nullopt;
        PoseSample sample;
        sample.time = t;
        sample.X_FO = kind == ObjectKind::Jaw ? pose->X_AJ : pose->X_AL;
        sample.validity = validity;
        return sample;
    }
    [[nodiscard]] QString told() const
    {
        return panel.findChild<QLabel*>(QStringLiteral("laryngoscopeText"))->text();
    }
    [[nodiscard]] SceneView& picture() const { return *pictureOf(panel); }
    [[nodiscard]] bool drawsMore(std::size_t frames) const
    {
        if (!hasPicture())
            return false;
        const std::size_t target = picture().statistics().frames + frames;
        return soon([&] { return picture().statistics().frames >= target; }, kDrawn);
    }
};

QComboBox& cameraOf(const LaryngoscopePanel& panel)
{
    return *panel.findChild<QComboBox*>(QStringLiteral("scopeCamera"));
}

ScopeCanvas& canvasOf(const LaryngoscopePanel& panel) { return *panel.findChild<ScopeCanvas*>(); }

/// Chooses the camera that is flown by hand, as a person does.
void chooseFlown(const LaryngoscopePanel& panel)
{
    cameraOf(panel).setCurrentIndex(1);
    Q_EMIT cameraOf(panel).activated(1);
}

/// The number in "Camera 84 mm past the teeth", below 0 in front of them; nothing without one.
std::optional<int> depthIn(const QString& told)
{
    const QStringList words = told.split(QLatin1Char{' '});
    if (words.size() < 3 || words[0] != QStringLiteral("Camera"))
        return std::nullopt;
    return (told.contains(QStringLiteral("in front of")) ? -1 : 1) * words[1].toInt();
}

/// The share of pixels that differ by more than a little.
double difference(const QImage& a, const QImage& b)
{
    constexpr int kLittle = 24; // grey levels
    if (a.size() != b.size() || a.isNull())
        return 1.0;
    int different = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            different += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > kLittle ? 1 : 0;
    return double(different) / (double(a.width()) * a.height());
}

} // namespace

class TestLaryngoscopePanel : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init()
    {
        if (!graphicsDriver())
            QSKIP("no OpenGL 3.3");
    }

    void saysWhatToDoWithoutALaryngoscope()
    {
        const Desk desk;
        QVERIFY(desk.drawsMore(2));
        QCOMPARE(desk.told(), laryngoscopeText(LaryngoscopeState::None));
    }

    void hasAPictureOfFourToThree()
    {
        const Desk desk;
        QVERIFY(desk.hasPicture());
        QCOMPARE(desk.picture().width() * 3, desk.picture().height() * 4);
        QVERIFY(desk.picture().width() >= 400);
        const auto& text = *desk.panel.findChild<QLabel*>(QStringLiteral("laryngoscopeText"));
        QVERIFY(!text.geometry().intersects(desk.picture().geometry()));
    }

    /// At the teeth no larynx is to be seen: grade 4 by definition. Lifted, some of it is.
    void drawsWhatTheBladeShowsAndGradesIt()
    {
        Desk desk;
        desk.pose = poseIn(LaryngoscopyStep::Teeth);
        QVERIFY(soon([&] { return desk.told().startsWith(QStringLiteral("Grade 4 ·")); }, kDrawn));
        QVERIFY(desk.drawsMore(8)); // with the shaders for it
        const QImage atTeeth = desk.picture().picture();
        desk.pose = poseIn(LaryngoscopyStep::Full);
        QVERIFY(soon(
            [&] {
                return desk.told().startsWith(QStringLiteral("Grade "))
                       && !desk.told().startsWith(QStringLiteral("Grade 4 ·"));
            },
            kDrawn));
        QVERIFY(difference(atTeeth, desk.picture().picture()) > 0.1);
        desk.pose = poseIn(LaryngoscopyStep::Teeth);
        QVERIFY(soon([&] { return desk.told().startsWith(QStringLiteral("Grade 4 ·")); }, kDrawn));
        QVERIFY(desk.drawsMore(8));
        QVERIFY(difference(atTeeth, desk.picture().picture()) < 0.05);
    }

    void showsTheLarynxOfThePatientOfThePrograms()
    {
        Desk desk{heldOpen()};
        desk.pose = poseIn(LaryngoscopyStep::Full, heldOpen());
        QVERIFY(soon(
            [&] {
                return desk.told().startsWith(QStringLiteral("Grade 1"))
                       || desk.told().startsWith(QStringLiteral("Grade 2"));
            },
            kDrawn));
    }

    void showsNothingOfALostOne()
    {
        Desk desk;
        desk.pose = poseIn(LaryngoscopyStep::Full);
        QVERIFY(soon([&] { return desk.told().startsWith(QStringLiteral("Grade ")); }, kDrawn));
        desk.validity = Validity::Lost;
        QVERIFY(
            soon([&] { return desk.told() == laryngoscopeText(LaryngoscopeState::Lost); }, kDrawn));
        QVERIFY(desk.drawsMore(2));
        const QImage dark = desk.picture().picture();
        const QRgb corner = dark.pixel(0, 0);
        QCOMPARE(dark.pixel(dark.width() / 2, dark.height() / 2), corner);
    }

    /// As many frames of another picture go by as would have been several of this one. Before it
    /// first was in front there is none.
    void drawsNothingBehindAnotherPanel()
    {
        constexpr std::size_t kFrames = 30;
        Desk desk;
        desk.panel.hide();
        desk.pose = poseIn(LaryngoscopyStep::Full);
        QMainWindow window;
        auto* panel = new LaryngoscopePanel;
        panel->setStation(desk.scene);
        QDockWidget scope;
        scope.setWidget(panel);
        QDockWidget other;
        other.setWidget(new QLabel{QStringLiteral("other")});
        window.addDockWidget(Qt::LeftDockWidgetArea, &scope);
        window.addDockWidget(Qt::LeftDockWidgetArea, &other);
        window.tabifyDockWidget(&scope, &other);
        other.raise();
        window.resize(640, 520);
        window.show();
        desk.patient.resize(320, 240);
        desk.patient.show();
        const auto goesOnFor = [&desk](std::size_t more) {
            const std::size_t target = desk.patient.statistics().frames + more;
            return soon([&] { return desk.patient.statistics().frames >= target; }, kDrawn);
        };
        QVERIFY(goesOnFor(kFrames));
        QVERIFY(!pictureOf(*panel));
        scope.raise();
        QVERIFY(soon([&] { return pictureOf(*panel) != nullptr; }, kDrawn));
        const auto frames = [panel] { return pictureOf(*panel)->statistics().frames; };
        QVERIFY(soon([&] { return frames() >= 2; }, kDrawn));
        other.raise();
        QVERIFY(soon([&] { return !isInsideWindow(*panel); }, kDrawn));
        const std::size_t before = frames();
        QVERIFY(goesOnFor(kFrames));
        QCOMPARE(frames(), before);
        scope.raise();
        QVERIFY(soon([&] { return frames() > before; }, kDrawn));
    }

    void drawsTheTissueOfThePatientsPictureLikewise()
    {
        Desk desk;
        desk.pose = poseIn(LaryngoscopyStep::Full);
        desk.patient.resize(320, 240);
        desk.patient.show();
        QVERIFY(soon([&] { return desk.patient.statistics().frames >= 2; }, kDrawn));
        QVERIFY(desk.patient.frame().blade.isThere());
        desk.validity = Validity::Lost;
        QVERIFY(soon([&] { return !desk.patient.frame().blade.isThere(); }, kDrawn));
    }

    void fliesAnEndoscopeByKeysWithoutALaryngoscope()
    {
        const Desk desk{heldOpen()};
        QVERIFY(desk.hasPicture());
        chooseFlown(desk.panel);
        QVERIFY(soon([&] { return depthIn(desk.told()).has_value(); }, kDrawn));
        const int before = *depthIn(desk.told());
        QVERIFY(before < -20 && before > -40);
        QVERIFY(!desk.panel.seen());
        QVERIFY(desk.drawsMore(8));
        const QImage mouth = desk.picture().picture();
        ScopeCanvas& canvas = canvasOf(desk.panel);
        for (int i = 0; i < 5; ++i)
            QTest::keyClick(&canvas, Qt::Key_W);
        const auto isAt = [&](int depth) {
            return soon(
                [&] {
                    const auto told = depthIn(desk.told());
                    return told && std::abs(*told - depth) <= 1;
                },
                kDrawn);
        };
        QVERIFY(isAt(before + 10)); // 5 times 2 mm
        QTest::keyClick(&canvas, Qt::Key_PageDown);
        QVERIFY(isAt(before + 8));
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(&canvas, Qt::Key_Left);
        QVERIFY(desk.drawsMore(8));
        QVERIFY(difference(mouth, desk.picture().picture()) > 0.1);
        QTest::keyClick(&canvas, Qt::Key_Home);
        QVERIFY(isAt(before));
        QVERIFY(desk.drawsMore(8));
        QVERIFY(difference(mouth, desk.picture().picture()) < 0.05);
    }

    void fliesByButtonsThatHaveNames()
    {
        const Desk desk{heldOpen()};
        QVERIFY(desk.hasPicture());
        const auto buttons = desk.panel.findChildren<QToolButton*>();
        for (const QToolButton* button : buttons)
            if (button->objectName().startsWith(QStringLiteral("fly"))) {
                QVERIFY(!button->isVisible());
                QVERIFY(button->accessibleName().size() > 5);
                QVERIFY(!button->toolTip().isEmpty());
            }
        chooseFlown(desk.panel);
        QVERIFY(soon([&] { return depthIn(desk.told()).has_value(); }, kDrawn));
        const int before = *depthIn(desk.told());
        auto& advance = *desk.panel.findChild<QToolButton*>(QStringLiteral("flyAdvance"));
        QVERIFY(advance.isVisible());
        for (int i = 0; i < 3; ++i)
            advance.click();
        QVERIFY(soon(
            [&] {
                const auto told = depthIn(desk.told());
                return told && std::abs(*told - before - 6) <= 1;
            },
            kDrawn));
        QVERIFY(canvasOf(desk.panel).hasFocus() || !desk.panel.isActiveWindow());
    }

    void isNotFlownWhereThereIsNoAirway()
    {
        const auto lacking = test::childWithout(PartRole::Trachea);
        const Desk desk{*lacking};
        const auto& rows = *qobject_cast<QStandardItemModel*>(cameraOf(desk.panel).model());
        QVERIFY(!rows.item(1)->isEnabled());
        QVERIFY(cameraOf(desk.panel).toolTip().contains(QStringLiteral("no trachea")));
        const Desk whole;
        const auto& choices = *qobject_cast<QStandardItemModel*>(cameraOf(whole.panel).model());
        QVERIFY(choices.item(1)->isEnabled());
    }

    void isNotGradedWhileAnEndoscopeIsFlown()
    {
        Desk desk;
        desk.pose = poseIn(LaryngoscopyStep::Full);
        QVERIFY(soon([&] { return desk.panel.seen().has_value(); }, kDrawn));
        chooseFlown(desk.panel);
        QVERIFY(soon([&] { return !desk.panel.seen().has_value(); }, kDrawn));
        QVERIFY(desk.drawsMore(4));
        QVERIFY(!desk.panel.seen().has_value());
        QVERIFY(desk.panel.effort().has_value()); // what the blade does is estimated nevertheless
    }

    void showsItsPictureOnTheWholeScreen()
    {
        Desk desk;
        desk.pose = poseIn(LaryngoscopyStep::Full);
        QVERIFY(soon([&] { return desk.panel.seen().has_value(); }, kDrawn));
        QTest::keyClick(&canvasOf(desk.panel), Qt::Key_F11);
        auto* window = desk.panel.findChild<ScopeWindow*>();
        QVERIFY(window && window->isFullScreen());
        QVERIFY(!desk.picture().isVisible());
        QVERIFY(soon([&] { return pictureOf(window->panel()) != nullptr; }, kDrawn));
        QVERIFY(soon([&] { return desk.panel.seen().has_value(); }, kDrawn)); // that which is there
        const SceneView& large = *pictureOf(window->panel());
        QCOMPARE(large.width() * 3, large.height() * 4);
        QVERIFY(large.width() > 640);
        QTest::keyClick(window, Qt::Key_Escape);
        QVERIFY(soon([&] { return desk.panel.findChild<ScopeWindow*>() == nullptr; }));
        QVERIFY(soon([&] { return desk.picture().isVisible(); }));
        QVERIFY(soon([&] { return desk.told().startsWith(QStringLiteral("Grade ")); }, kDrawn));
    }
};

CARINA_SCREEN_TEST(TestLaryngoscopePanel)

} // namespace carina::laryngoscope_panel_test

#include "tst_laryngoscope_panel.moc"
