#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "ui/panels/patient/parts_panel.h"
#include "ui/scene/part_chooser.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/scene/view/scene_window.h"

#include <QGuiApplication>
#include <QSignalSpy>
#include <QTreeWidget>

#include <cmath>

namespace carina::part_chooser_test
{
namespace
{

using test::draws;

constexpr std::uint16_t kLobe = 1;
constexpr std::uint16_t kRib = 2;
constexpr std::uint16_t kOtherRib = 3;
constexpr double kBeside = 0.3; ///< metres to the side, of the second rib

ScenePart ball(std::uint16_t id, MaterialGroup group, const char* name, const Vec3& p_A)
{
    ScenePart part = test::spherePart(id, group, p_A, 0.1);
    part.name = name;
    part.listedUnder = group == MaterialGroup::Lung ? BodyRegion::Lungs : BodyRegion::Skeleton;
    return part;
}

/// Off the middle, in which edges of triangles meet.
QPoint inFront() { return {test::kWidth / 2 + 10, test::kHeight / 2 - 7}; }

/// The pixel where the second rib is seen.
QPoint beside()
{
    const double focal = 0.5 * test::kHeight / std::tan(0.5 * OrbitCamera::kVerticalFieldOfView);
    return inFront() + QPoint{qRound(focal * kBeside / test::kDistance), 0};
}

/// A lobe with a rib behind it, and another rib beside them.
struct Shown {
    std::unique_ptr<SceneView> view =
        test::shownView({ball(kLobe, MaterialGroup::Lung, "Upper lobe", Vec3::Zero()),
                         ball(kRib, MaterialGroup::Bone, "First rib", {0.0, 0.5, 0.0}),
                         ball(kOtherRib, MaterialGroup::Bone, "Second rib", {kBeside, 0.0, 0.0})},
                        [](int, LocalTime) { return test::frontFrame(); });
    PartsPanel panel;
    PartChooser chooser{*view, panel};
    QSignalSpy chosen{&chooser, &PartChooser::chosen};
    QSignalSpy chosenInList{&panel, &PartsPanel::chosenInList};

    Shown()
    {
        panel.setScene(*view);
        panel.show();
    }
    [[nodiscard]] bool isDrawn() const { return draws(*view, 3); }
    /// The name that is told after a click.
    [[nodiscard]] QString click(const QPoint& place)
    {
        const qsizetype before = chosen.size();
        for (QWindow* window : QGuiApplication::allWindows())
            if (qobject_cast<SceneWindow*>(window))
                QTest::mouseClick(window, Qt::LeftButton, {}, place);
        return chosen.size() == before + 1 ? chosen.last()[0].toString()
                                           : QStringLiteral("not told once");
    }
    /// The names that are chosen in the list.
    [[nodiscard]] QStringList listed() const
    {
        QStringList names;
        for (const QTreeWidgetItem* item : panel.findChild<QTreeWidget*>()->selectedItems())
            names += item->text(0);
        return names;
    }
};

} // namespace

/// A part is chosen by a click in the picture.
class TestPartChooser : public QObject
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

    void choosesThePartThatIsClicked()
    {
        Shown shown;
        QVERIFY(shown.isDrawn());
        QCOMPARE(shown.click(inFront()), QStringLiteral("Upper lobe"));
        QCOMPARE(shown.listed(), QStringList{QStringLiteral("Upper lobe")});
        QCOMPARE(shown.click(beside()), QStringLiteral("Second rib"));
        QCOMPARE(shown.listed(), QStringList{QStringLiteral("Second rib")});
        QCOMPARE(shown.chosenInList.size(), 0); // nobody chose there
    }

    void goesToWhatIsBehindWithEachFurtherClick()
    {
        Shown shown;
        QVERIFY(shown.isDrawn());
        for (const char* name : {"Upper lobe", "First rib", "Upper lobe"})
            QCOMPARE(shown.click(inFront()), QString::fromLatin1(name));
        QCOMPARE(shown.click(inFront()), QStringLiteral("First rib"));
        QCOMPARE(shown.click(beside()), QStringLiteral("Second rib"));
        QCOMPARE(shown.click(inFront()), QStringLiteral("Upper lobe")); // begins anew
    }

    void choosesNothingBesideThePatient()
    {
        Shown shown;
        QVERIFY(shown.isDrawn());
        QCOMPARE(shown.click(inFront()), QStringLiteral("Upper lobe"));
        QCOMPARE(shown.click({5, 5}), QString{});
        QCOMPARE(shown.listed(), QStringList{});
    }

    void choosesOnlyWhatIsDrawn()
    {
        Shown shown;
        shown.view->setLooks({{kLobe, {.style = PartStyle::Hidden}}});
        QVERIFY(shown.isDrawn());
        QCOMPARE(shown.click(inFront()), QStringLiteral("First rib"));
        shown.view->setLooks({});
        shown.view->setSection(Section{-Vec3::UnitY(), -0.2, Cut::All}); // y above 0.2 stays
        QVERIFY(shown.isDrawn());
        QCOMPARE(shown.click(inFront()), QStringLiteral("First rib"));
        QCOMPARE(shown.click(beside()), QString{});
    }
};

CARINA_SCREEN_TEST(TestPartChooser)

} // namespace carina::part_chooser_test

#include "tst_part_chooser.moc"
