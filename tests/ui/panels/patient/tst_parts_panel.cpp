#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "ui/panels/patient/parts_panel.h"
#include "ui/panels/patient/section_panel.h"
#include "widgets/scene/view/graphics.h"

#include <QAccessible>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTreeWidget>

namespace carina::parts_panel_test
{
namespace
{

using test::draws;

constexpr std::uint16_t kLobe = 1;
constexpr std::uint16_t kRib = 2;
constexpr std::uint16_t kOtherRib = 3;

ScenePart named(std::uint16_t id, MaterialGroup group, const char* name, double x)
{
    ScenePart part = test::spherePart(id, group, {x, 0.0, 0.0}, 0.1);
    part.name = name;
    part.listedUnder = group == MaterialGroup::Lung ? BodyRegion::Lungs : BodyRegion::Skeleton;
    return part;
}

struct Shown {
    std::unique_ptr<SceneView> view =
        test::shownView({named(kLobe, MaterialGroup::Lung, "Upper lobe", 0.0),
                         named(kRib, MaterialGroup::Veil, "First rib", -0.3),
                         named(kOtherRib, MaterialGroup::Veil, "Second rib", 0.3)},
                        [](int, LocalTime) { return test::frontFrame(); });
    PartsPanel panel;
    QTreeWidget* list = panel.findChild<QTreeWidget*>();
    QLineEdit* words = panel.findChild<QLineEdit*>();

    Shown()
    {
        panel.setScene(*view);
        panel.show();
    }
    [[nodiscard]] QPushButton* button(const char* text) const
    {
        for (QPushButton* found : panel.findChildren<QPushButton*>())
            if (found->text().remove(QLatin1Char{'&'}) == QLatin1String{text})
                return found;
        return nullptr;
    }
    [[nodiscard]] QTreeWidgetItem* item(const char* name) const
    {
        return list->findItems(QLatin1String{name}, Qt::MatchExactly | Qt::MatchRecursive).value(0);
    }
    void choose(const char* name) const
    {
        list->clearSelection();
        item(name)->setSelected(true);
    }
    [[nodiscard]] PartLook look(std::uint16_t id) const
    {
        const auto found = view->looks().find(id);
        return found == view->looks().end() ? PartLook{} : found->second;
    }
};

} // namespace

class TestPartsPanel : public QObject
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

    void listsThePartsByRegionAndName()
    {
        const Shown shown;
        QCOMPARE(shown.list->topLevelItemCount(), 2); // regions without parts are left out
        QCOMPARE(shown.list->topLevelItem(0)->text(0), QStringLiteral("Lungs"));
        const QTreeWidgetItem* skeleton = shown.list->topLevelItem(1);
        QCOMPARE(skeleton->text(0), QStringLiteral("Skeleton"));
        QCOMPARE(skeleton->childCount(), 2);
        QCOMPARE(skeleton->child(0)->text(0), QStringLiteral("First rib"));
        QCOMPARE(skeleton->child(1)->text(0), QStringLiteral("Second rib"));
        QCOMPARE(skeleton->text(1), QStringLiteral("2 of 2"));
        QCOMPARE(shown.item("Upper lobe")->text(1), QStringLiteral("as usual"));
        for (const char* text : {"As usual", "Solid", "Ghost", "Hide", "Highlight", "Name"})
            QVERIFY(!shown.button(text)->isEnabled()); // nothing is chosen
    }

    void changesWhatIsChosen_data()
    {
        QTest::addColumn<QByteArray>("button");
        QTest::addColumn<PartLook>("look");
        QTest::addColumn<QString>("word");
        using Look = PartLook;
        QTest::newRow("solid") << QByteArray{"Solid"} << Look{PartStyle::Solid}
                               << QStringLiteral("solid");
        QTest::newRow("ghost") << QByteArray{"Ghost"} << Look{PartStyle::Ghost}
                               << QStringLiteral("ghost");
        QTest::newRow("hidden") << QByteArray{"Hide"} << Look{PartStyle::Hidden}
                                << QStringLiteral("hidden");
        QTest::newRow("highlighted") << QByteArray{"Highlight"} << Look{.highlighted = true}
                                     << QStringLiteral("highlighted");
        QTest::newRow("named") << QByteArray{"Name"} << Look{.labelled = true}
                               << QStringLiteral("as usual, named");
        QTest::newRow("plain") << QByteArray{"Plain colour"} << Look{.plain = true}
                               << QStringLiteral("as usual, plain colour");
    }

    void changesWhatIsChosen()
    {
        QFETCH(QByteArray, button);
        QFETCH(PartLook, look);
        const Shown shown;
        shown.choose("Second rib");
        shown.button(button.constData())->click();
        QVERIFY(shown.look(kOtherRib) == look);
        QVERIFY(shown.look(kRib) == PartLook{});
        QTEST(shown.item("Second rib")->text(1), "word");
        shown.button("Show all as usual")->click();
        QVERIFY(shown.look(kOtherRib) == PartLook{});
    }

    void showsAndHidesByCheckBox()
    {
        const Shown shown;
        QTreeWidgetItem* region = shown.item("Skeleton");
        shown.item("First rib")->setCheckState(0, Qt::Unchecked);
        QVERIFY(shown.look(kRib).style == PartStyle::Hidden);
        QVERIFY(shown.look(kOtherRib) == PartLook{});
        QCOMPARE(region->checkState(0), Qt::PartiallyChecked);
        QCOMPARE(region->text(1), QStringLiteral("1 of 2"));
        shown.item("First rib")->setCheckState(0, Qt::Checked);
        QVERIFY(shown.look(kRib) == PartLook{});
        QCOMPARE(region->checkState(0), Qt::Checked);
    }

    void showsAndHidesAWholeRegion()
    {
        const Shown shown;
        QTreeWidgetItem* region = shown.item("Skeleton");
        region->setCheckState(0, Qt::Unchecked);
        for (const std::uint16_t rib : {kRib, kOtherRib})
            QVERIFY(shown.look(rib).style == PartStyle::Hidden);
        QVERIFY(shown.look(kLobe) == PartLook{});
        QCOMPARE(shown.item("First rib")->checkState(0), Qt::Unchecked);
        region->setCheckState(0, Qt::Checked);
        for (const std::uint16_t rib : {kRib, kOtherRib})
            QVERIFY(shown.look(rib) == PartLook{});
    }

    void keepsHowAPartIsShownWhereItIsShown()
    {
        const Shown shown;
        shown.choose("First rib");
        shown.button("Ghost")->click();
        shown.item("Second rib")->setCheckState(0, Qt::Unchecked);
        shown.item("Skeleton")->setCheckState(0, Qt::Checked);
        QVERIFY(shown.look(kRib).style == PartStyle::Ghost);
        QVERIFY(shown.look(kOtherRib).style == PartStyle::AsUsual);
    }

    void actsOnWhatASearchLeavesOfARegion()
    {
        const Shown shown;
        shown.words->setText(QStringLiteral("second"));
        QTreeWidgetItem* region = shown.item("Skeleton");
        QVERIFY(region->isExpanded() && !region->isHidden());
        QVERIFY(shown.item("Lungs")->isHidden());
        QCOMPARE(region->text(1), QStringLiteral("1 of 1"));
        region->setCheckState(0, Qt::Unchecked);
        QVERIFY(shown.look(kOtherRib).style == PartStyle::Hidden);
        QVERIFY(shown.look(kRib) == PartLook{});
        shown.words->clear();
        QCOMPARE(region->checkState(0), Qt::PartiallyChecked);
    }

    void appliesTheButtonsToARegion()
    {
        const Shown shown;
        shown.choose("Skeleton");
        shown.button("Ghost")->click();
        QVERIFY(shown.look(kRib).style == PartStyle::Ghost);
        QVERIFY(shown.look(kOtherRib).style == PartStyle::Ghost);
        QVERIFY(shown.look(kLobe) == PartLook{});
    }

    void drawsWhatItSays()
    {
        const Shown shown;
        shown.choose("First rib");
        shown.button("Hide")->click();
        QVERIFY(draws(*shown.view, 3));
        auto pixels = shown.view->visiblePixels();
        QCOMPARE(pixels[kRib], std::size_t{0});
        QVERIFY(pixels[kLobe] > 0 && pixels[kOtherRib] > 0);
    }

    void switchesOffWhatIsOn()
    {
        const Shown shown;
        shown.choose("First rib");
        shown.button("Name")->click();
        QVERIFY(shown.button("Name")->isChecked());
        shown.choose("Second rib");
        QVERIFY(!shown.button("Name")->isChecked());
        shown.choose("First rib");
        shown.button("Name")->click();
        QVERIFY(!shown.look(kRib).labelled);
    }

    void offersPlainColoursOnlyWherePartsCameWithColours()
    {
        Shown shown;
        QVERIFY(!shown.button("Plain colour")->isVisibleTo(&shown.panel));
        ScenePart skin = named(kLobe, MaterialGroup::Skin, "Skin", 0.0);
        for (const auto& level : skin.levels)
            skin.colors.emplace_back(level->positions.size(), Rgb{200, 120, 90});
        shown.view->setParts(std::vector{skin});
        shown.panel.setScene(*shown.view);
        QVERIFY(shown.button("Plain colour")->isVisibleTo(&shown.panel));
    }

    void findsPartsByWords()
    {
        const Shown shown;
        QTest::keyClicks(shown.words, QStringLiteral("RIB s"));
        QVERIFY(shown.item("First rib")->isHidden() == false); // "firSt rib" has an s
        QVERIFY(shown.item("Upper lobe")->isHidden());
        shown.list->selectAll();
        shown.button("Ghost")->click();
        QVERIFY(shown.look(kRib).style == PartStyle::Ghost);
        QVERIFY(shown.look(kLobe) == PartLook{});
    }

    void worksByKeyboard()
    {
        const Shown shown;
        QTest::keyClick(shown.list, Qt::Key_Home);
        QTest::keyClick(shown.list, Qt::Key_End); // the last region
        QTest::keyClick(shown.list, Qt::Key_Right);
        QVERIFY(shown.item("Skeleton")->isExpanded());
        QTest::keyClick(shown.list, Qt::Key_Down);
        QTest::keyClick(shown.list, Qt::Key_Down, Qt::ShiftModifier);
        QTest::keyClick(shown.button("Ghost"), Qt::Key_Space);
        QVERIFY(shown.look(kRib).style == PartStyle::Ghost);
        QVERIFY(shown.look(kOtherRib).style == PartStyle::Ghost);
        QVERIFY(shown.look(kLobe) == PartLook{});
        QTest::keyClick(shown.list, Qt::Key_Home);
        QTest::keyClick(shown.list, Qt::Key_Space); // its check box
        QVERIFY(shown.look(kLobe).style == PartStyle::Hidden);
        const QString spoken =
            shown.list->topLevelItem(0)->data(0, Qt::AccessibleTextRole).toString();
        QCOMPARE(spoken, QStringLiteral("Lungs, 0 of 1 parts shown"));
    }

    void givesEveryControlAName()
    {
        const Shown shown;
        SectionPanel section;
        section.setScene(*shown.view);
        for (const QWidget* panel : std::initializer_list<const QWidget*>{&shown.panel, &section})
            for (QWidget* control : panel->findChildren<QWidget*>())
                if (control->focusPolicy() != Qt::NoFocus && control->isVisibleTo(panel)
                    && !control->objectName().startsWith(QLatin1String{"qt_"}))
                    QVERIFY2(!QAccessible::queryAccessibleInterface(control)
                                  ->text(QAccessible::Name)
                                  .isEmpty(),
                             qPrintable(control->objectName()));
    }

    void takesItsChangesBack()
    {
        Shown shown;
        ChangeHistory history;
        shown.panel.setHistory(history);
        shown.choose("First rib");
        shown.button("Ghost")->click();
        shown.button("Highlight")->click();
        const PartLook prepared = shown.look(kRib);
        shown.panel.findChild<QPushButton*>(QStringLiteral("showAll"))->click();
        QVERIFY(shown.look(kRib) == PartLook{});
        QCOMPARE(history.texts(), (QStringList{QStringLiteral("All parts → as usual"),
                                               QStringLiteral("First rib → highlight"),
                                               QStringLiteral("First rib → ghost")}));
        history.undo();
        QVERIFY(shown.look(kRib) == prepared);
        QVERIFY(shown.button("Highlight")->isChecked());
        history.undo(2);
        QVERIFY(shown.look(kRib) == PartLook{});
        shown.item("Skeleton")->setCheckState(0, Qt::Unchecked);
        QCOMPARE(history.texts(), QStringList{QStringLiteral("2 parts → hidden")});
        history.undo();
        QVERIFY(shown.look(kOtherRib) == PartLook{});
        shown.choose("First rib");
        shown.button("Solid")->click();
        shown.panel.setScene(*shown.view); // another patient
        QVERIFY(history.isEmpty());
    }

    void takesACutBack()
    {
        const Shown shown;
        SectionPanel panel;
        ChangeHistory history;
        panel.setHistory(history);
        panel.setScene(*shown.view);
        QVERIFY(history.isEmpty()); // nobody cut
        auto* what = panel.findChild<QComboBox*>(QStringLiteral("what"));
        auto* side = panel.findChild<QComboBox*>(QStringLiteral("cutFrom"));
        auto* depth = panel.findChild<QSpinBox*>();
        what->setCurrentIndex(2);
        panel.findChild<QSlider*>()->setValue(60);
        panel.findChild<QSlider*>()->setValue(80); // goes on
        const auto prepared = panel.section();
        QCOMPARE(history.texts().size(), 2);
        QVERIFY(history.texts()[0].contains(QStringLiteral("80")));
        side->setCurrentIndex(2);
        QCOMPARE(history.texts().size(), 3);
        history.undo();
        QCOMPARE(side->currentIndex(), 0);
        QCOMPARE(depth->value(), 80);
        QVERIFY(panel.section()->distance == prepared->distance);
        history.undo();
        QCOMPARE(depth->value(), 100);
        history.undo();
        QVERIFY(!panel.section());
        QVERIFY(history.isEmpty());
    }

    /// As it was shown by a console that stopped.
    void putsPartsAndCutAsTheyWere()
    {
        Shown shown;
        SectionPanel section;
        ChangeHistory history;
        section.setScene(*shown.view);
        section.setHistory(history);
        shown.panel.setHistory(history);
        const SceneSettings wanted{Section{Vec3::UnitX(), 0.2, Cut::AllButAirway},
                                   {{kRib, {.style = PartStyle::Ghost, .labelled = true}}}};
        section.put(wanted.section);
        shown.panel.put(wanted.looks);
        QVERIFY(shown.view->settings().looks == wanted.looks);
        QVERIFY(std::abs(section.section()->distance - 0.2) < 1e-6);
        QVERIFY(section.section()->normal_A == Vec3::UnitX());
        QVERIFY(section.section()->cut == Cut::AllButAirway);
        QVERIFY(shown.view->settings().section == section.section());
        QCOMPARE(shown.item("First rib")->text(1), QStringLiteral("ghost, named"));
        QCOMPARE(history.texts().size(), 2); // each is one change
        section.put(section.section());
        shown.panel.put(wanted.looks);
        section.put(Section{Vec3{0.6, 0.8, 0.0}, 0.0, Cut::All}); // it has no such side
        QCOMPARE(history.texts().size(), 2);
        history.undo(2);
        QVERIFY(shown.view->settings() == SceneSettings{});
        section.put(wanted.section);
        section.put(std::nullopt);
        QVERIFY(!section.section());
    }

    void cutsTheSceneOpen()
    {
        const Shown shown;
        SectionPanel panel;
        panel.setScene(*shown.view);
        auto* what = panel.findChild<QComboBox*>(QStringLiteral("what"));
        auto* side = panel.findChild<QComboBox*>(QStringLiteral("cutFrom"));
        auto* depth = panel.findChild<QSpinBox*>();
        QVERIFY(!panel.section());
        QVERIFY(!depth->isEnabled());
        what->setCurrentIndex(2);
        QVERIFY(depth->isEnabled());
        QCOMPARE(depth->maximum(), 200); // the balls are 200 mm deep
        QCOMPARE(depth->value(), 100);
        QVERIFY(panel.section()->normal_A == -Vec3::UnitY());
        QVERIFY(std::abs(panel.section()->distance) < 1e-6);
        QVERIFY(panel.section()->cut == Cut::All);
        what->setCurrentIndex(1);
        QVERIFY(panel.section()->cut == Cut::AllButAirway);
        what->setCurrentIndex(2);
        side->setCurrentIndex(2); // from the left: 800 mm, of which the outer ball has 200
        QCOMPARE(depth->value(), 400);
        panel.findChild<QSlider*>()->setValue(205);
        QCOMPARE(depth->value(), 205);
        QVERIFY(draws(*shown.view, 3));
        auto pixels = shown.view->visiblePixels();
        QCOMPARE(pixels[kOtherRib], std::size_t{0});
        QVERIFY(pixels[kLobe] > 0 && pixels[kRib] > 0);
        what->setCurrentIndex(0);
        QVERIFY(draws(*shown.view, 3));
        QVERIFY(shown.view->visiblePixels()[kOtherRib] > 0);
    }
};

CARINA_SCREEN_TEST(TestPartsPanel)

} // namespace carina::parts_panel_test

#include "tst_parts_panel.moc"
