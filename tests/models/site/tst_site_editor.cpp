#include "models/site/site_editor.h"

#include "engine/io/site/site_file.h"
#include "tests/models/registration/made_site.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>
#include <QTemporaryDir>

#include <limits>

namespace carina::site_editor_test
{
namespace
{

struct Edited {
    [[nodiscard]] Site kept() const { return readSiteFile(file).value(); }
    /// A folder in the place of the file: nothing can be written.
    void block() const
    {
        std::filesystem::remove(file);
        std::filesystem::create_directory(file);
    }
    void unblock() const { std::filesystem::remove(file); }

    QTemporaryDir folder;
    std::filesystem::path file = folder.filePath(QStringLiteral("site.json")).toStdString();
    SiteEditor editor{file, {}, [] {
                          return QDateTime{{2004, 3, 27}, {10, 15}, Qt::OffsetFromUTC, 3600};
                      }};
    QSignalSpy changes{&editor, &SiteEditor::changed};
};

} // namespace

class TestSiteEditor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsEachChange()
    {
        Edited edited;
        QVERIFY(!std::filesystem::exists(edited.file));
        QVERIFY(edited.editor.become(test::preparedSite()));
        QCOMPARE(edited.kept().tracker, test::kTracker);
        QCOMPARE(edited.changes.count(), 1);
        QVERIFY(edited.editor.canUndo());
    }

    void undoesEachChangeAsAWhole()
    {
        Edited edited;
        edited.editor.become(test::preparedSite());
        edited.editor.become(test::fittedSite());
        edited.editor.undo();
        QVERIFY(!edited.editor.site().registration && edited.editor.site().touched.empty());
        QVERIFY(!edited.kept().registration);
        edited.editor.undo();
        QVERIFY(edited.kept().tracker.empty());
        QVERIFY(!edited.editor.canUndo());
        edited.editor.undo();
        QCOMPARE(edited.changes.count(), 4);
    }

    /// To look at a page is nothing to be undone.
    void showsPagesWithoutUndo()
    {
        Edited edited;
        edited.editor.become(test::preparedSite());
        edited.editor.enter(SiteStep::Fit);
        QCOMPARE(edited.kept().step, SiteStep::Fit);
        edited.editor.undo();
        QVERIFY(!edited.editor.canUndo());
        QVERIFY(edited.editor.site().tracker.empty());
    }

    void refusesWhatCannotBeKept()
    {
        Edited edited;
        edited.editor.become(test::preparedSite());
        edited.block();
        QVERIFY(!edited.editor.become(test::fittedSite()));
        QVERIFY(!edited.editor.problem().isEmpty());
        QVERIFY(!edited.editor.site().registration);
        edited.editor.enter(SiteStep::Fit); // pages can be looked at
        QCOMPARE(edited.editor.site().step, SiteStep::Fit);
        QVERIFY(!edited.editor.problem().isEmpty());
        edited.editor.undo();
        QVERIFY(edited.editor.canUndo() && !edited.editor.site().tracker.empty());
        edited.unblock();
        QVERIFY(edited.editor.become(test::fittedSite()));
        QVERIFY(edited.editor.problem().isEmpty());
        QVERIFY(edited.kept().registration.has_value());
    }

    void refusesWhatCouldNotBeReadAgain()
    {
        Edited edited;
        edited.editor.become(test::touchedSite());
        Site broken = edited.editor.site();
        broken.touched[0].p_TQ.x() = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!edited.editor.become(broken));
        QVERIFY(edited.editor.site().touched[0].p_TQ.allFinite());
        QVERIFY(edited.kept().touched[0].p_TQ.allFinite());
    }

    void tellsAProblemUntilSomethingGoesRight()
    {
        Edited edited;
        edited.editor.refuse(QStringLiteral("No."));
        QCOMPARE(edited.editor.problem(), QStringLiteral("No."));
        edited.editor.refuse(Error{Errc::TooFewLandmarks, "2"});
        QVERIFY(!edited.editor.problem().isEmpty());
        QVERIFY(edited.editor.problem() != QStringLiteral("No."));
        QCOMPARE(edited.changes.count(), 2);
        edited.editor.enter(SiteStep::Stylus);
        QVERIFY(edited.editor.problem().isEmpty());
    }

    void confirmsUntilSomethingElseHappens()
    {
        Edited edited;
        edited.editor.refuse(QStringLiteral("No."));
        edited.editor.confirm(QStringLiteral("Written."));
        QCOMPARE(edited.editor.notice(), QStringLiteral("Written."));
        QVERIFY(edited.editor.problem().isEmpty());
        QCOMPARE(edited.changes.count(), 2);
        edited.editor.refuse(QStringLiteral("No."));
        QVERIFY(edited.editor.notice().isEmpty());
        edited.editor.confirm(QStringLiteral("Written."));
        edited.editor.enter(SiteStep::Stylus);
        QVERIFY(edited.editor.notice().isEmpty());
    }

    void writesTimesInUtc()
    {
        const Edited edited;
        QCOMPARE(edited.editor.now(), std::string{"2004-03-27T09:15:00Z"});
    }

    void passesOnWhatIsToBeHeard()
    {
        Edited edited;
        QSignalSpy told{&edited.editor, &SiteEditor::told};
        edited.editor.tell(QStringLiteral("The tip is found"));
        QCOMPARE(told[0][0].toString(), QStringLiteral("The tip is found"));
    }
};

CARINA_TEST(TestSiteEditor)

} // namespace carina::site_editor_test

#include "tst_site_editor.moc"
