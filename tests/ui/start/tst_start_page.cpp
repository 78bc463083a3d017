#include "engine/anatomy/patient/patient_name.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/io/fact_store/sql_fact_store.h"
#include "engine/session/facts/fact_codec.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"
#include "ui/start/end_page.h"
#include "ui/start/leave_question.h"
#include "ui/start/start_page.h"
#include "widgets/scene/view/graphics.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTimer>

#include <algorithm>
#include <array>

namespace carina::start_page_test
{
namespace
{

constexpr std::chrono::seconds kMade{60}; ///< a patient, on a busy machine

template <class Widget> Widget& find(const QWidget& window, const char* name)
{
    return *window.findChild<Widget*>(QLatin1String{name});
}

/// A page over an empty folder.
struct Shown {
    test::ScratchFolder folder;
    QString disk = QStringLiteral("✓ 9 GB free");
    StoredSessionsModel stored{folder.path()};
    PlannedPatient patient{AnatomyCache::defaultFolder()};
    StartPage page{stored,
                   patient,
                   {.name = QStringLiteral("Ward 3"), .patient = QStringLiteral("child")},
                   [this](const QString&, const PatientModel*) {
                       return std::vector<ReadyLine>{{QStringLiteral("Disk"), disk}};
                   }};

    [[nodiscard]] bool isMade() const
    {
        return test::soon([this] { return patient.patient().has_value(); }, kMade);
    }
};

/// A session that was left, as it is stored.
void storeSession(const QString& file, const char* name, SessionReach reach)
{
    std::uint64_t number = 0;
    const auto record = [&number](StationId station, FactBody body) {
        ++number;
        return toRecord(Fact{FactNumber{number}, ProposalId{number}, ParticipantId{0}, station,
                             SessionTime{}, SessionTime{}, std::move(body)});
    };
    const std::array facts{record(kNoStation, fact::SessionCreated{name, "00ff"}),
                           record(StationId{0}, fact::StationAdded{"Station 1"})};
    auto store = openFactStore(file.toStdString());
    QVERIFY(store.has_value());
    QVERIFY((*store)->append(facts).has_value());
    keepReach(file, reach);
}

/// Presses a button of the question that comes up, for as long as it is there.
void answerWith(const char* button)
{
    auto* timer = new QTimer{qApp};
    QObject::connect(timer, &QTimer::timeout, timer, [timer, button] {
        if (const QWidget* box = QApplication::activeModalWidget()) {
            box->findChild<QPushButton*>(QLatin1String{button})->click();
            timer->deleteLater();
        }
    });
    timer->start(10);
}

} // namespace

class TestStartPage : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void saysWhatIsWantedOnceThePatientIsThere()
    {
        Shown shown;
        QVERIFY(!find<QPushButton>(shown.page, "begin").isEnabled());
        QVERIFY(shown.isMade());
        QVERIFY(find<QPushButton>(shown.page, "begin").isEnabled());
        QSignalSpy wanted{&shown.page, &StartPage::beginWanted};
        find<QPushButton>(shown.page, "begin").click();
        QCOMPARE(wanted.size(), 1);
        const SessionPlan plan = shown.page.plan();
        QCOMPARE(plan.name, QStringLiteral("Ward 3"));
        QCOMPARE(plan.patient, QStringLiteral("child"));
        QVERIFY(plan.folder.isEmpty() && plan.reach == SessionReach::ThisComputer);
    }

    void offersTheChildWhereNobodyWasNamed()
    {
        Shown shown;
        const StartPage page{shown.stored, shown.patient, {}, [](const QString&, const auto*) {
                                 return std::vector<ReadyLine>{};
                             }};
        QCOMPARE(page.plan().patient, QStringLiteral("child"));
    }

    void beginsNothingWithoutAName()
    {
        Shown shown;
        QVERIFY(shown.isMade());
        find<QLineEdit>(shown.page, "name").clear();
        QVERIFY(!find<QPushButton>(shown.page, "begin").isEnabled());
        QVERIFY(find<QLabel>(shown.page, "missing").text().contains(QStringLiteral("name")));
    }

    void offersAnInfant()
    {
        Shown shown;
        auto& who = find<QComboBox>(shown.page, "patient");
        const int infant = who.findText(QStringLiteral("Infant"), Qt::MatchStartsWith);
        QVERIFY(infant >= 0);
        who.setCurrentIndex(infant);
        const auto patient = patientFromWords(shown.page.plan().patient.toStdString());
        QVERIFY(patient && patient->ageInYears <= 1.0);
        QVERIFY(shown.isMade());
        QVERIFY(find<QPushButton>(shown.page, "begin").isEnabled());
    }

    void takesAPatientFromFigures()
    {
        Shown shown;
        auto& who = find<QComboBox>(shown.page, "patient");
        auto& figures = find<QLineEdit>(shown.page, "figures");
        QVERIFY(!figures.isEnabled());
        who.setCurrentText(QStringLiteral("From figures"));
        QVERIFY(figures.isEnabled());
        figures.setText(QStringLiteral("a horse"));
        QVERIFY(!find<QPushButton>(shown.page, "begin").isEnabled());
        const auto& missing = find<QLabel>(shown.page, "missing");
        QVERIFY(!missing.text().isEmpty());
        figures.setText(QStringLiteral("91 years, 300 cm, man"));
        QVERIFY(!find<QPushButton>(shown.page, "begin").isEnabled());
        for (const char* range : {"91 years", "0 to 90 years", "300 cm", "100 to 210 cm"})
            QVERIFY2(missing.text().contains(QLatin1String{range}), qPrintable(missing.text()));
        figures.setText(QStringLiteral("adult"));
        QVERIFY(shown.isMade());
        QCOMPARE(shown.page.plan().patient, QStringLiteral("adult"));
        QVERIFY(find<QPushButton>(shown.page, "begin").isEnabled());
    }

    /// Nobody else is laid in their place.
    void waitsForTheSurfacesOfAFolder()
    {
        Shown shown;
        QVERIFY(shown.isMade());
        find<QComboBox>(shown.page, "patient")
            .setCurrentText(QStringLiteral("From a folder of surfaces"));
        QVERIFY(!find<QPushButton>(shown.page, "begin").isEnabled());
        QVERIFY(find<QPushButton>(shown.page, "browse").isEnabled());
        QVERIFY(find<QLabel>(shown.page, "missing").text().contains(QStringLiteral("folder")));
    }

    void saysInOneSentenceWhoCanJoin()
    {
        Shown shown;
        const auto& meaning = find<QLabel>(shown.page, "meaning");
        QCOMPARE(meaning.text(), reachMeaning(SessionReach::ThisComputer));
        find<QRadioButton>(shown.page, "byLink").click();
        QCOMPARE(meaning.text(), reachMeaning(SessionReach::ByLink));
        QVERIFY(shown.page.plan().reach == SessionReach::ByLink);
    }

    void keepsUpWithWhatIsReady()
    {
        Shown shown;
        const auto isTold = [&shown] {
            const auto labels = shown.page.findChildren<QLabel*>(QStringLiteral("ready"));
            return std::ranges::any_of(
                labels, [&](const QLabel* label) { return label->text() == shown.disk; });
        };
        QVERIFY(isTold());
        shown.disk = QStringLiteral("▲ 1 MB free");
        QVERIFY(test::soon(isTold, std::chrono::seconds{10})); // by itself
        shown.disk = QStringLiteral("✓ 5 GB free");
        QEvent back{QEvent::WindowActivate};
        QCoreApplication::sendEvent(&shown.page, &back);
        QVERIFY(isTold()); // at once
    }

    /// So that one press goes on with it, and a new session begins as if there were none.
    void preselectsTheLastSessionThatCanBeResumed()
    {
        const test::ScratchFolder folder;
        storeSession(folder.filePath("session-20260102-101112-000.sqlite"), "Early",
                     SessionReach::ByLink);
        const QString late = folder.filePath("session-20260103-101112-000.sqlite");
        storeSession(late, "Late", SessionReach::Network);
        folder.write("session-20260104-101112-000.sqlite", "no database");
        StoredSessionsModel stored{folder.path()};
        PlannedPatient patient{AnatomyCache::defaultFolder()};
        StartPage page{
            stored,
            patient,
            {.name = QStringLiteral("Ward 3"), .patient = QStringLiteral("child")},
            [](const QString&, const PatientModel*) { return std::vector<ReadyLine>{}; }};
        page.show();
        QVERIFY(test::soon([&stored] { return stored.isComplete(); }));
        auto& list = find<QListView>(page, "earlier");
        QVERIFY(list.currentIndex().data().toString().contains(QStringLiteral("Late")));
        QVERIFY(list.selectionModel()->isSelected(list.currentIndex()));
        QVERIFY(page.plan().reach == SessionReach::ThisComputer);
        QVERIFY(find<QRadioButton>(page, "thisComputer").isChecked());
        QCOMPARE(find<QLabel>(page, "meaning").text(), reachMeaning(SessionReach::ThisComputer));
        auto& reach = find<QComboBox>(page, "earlierReach");
        const auto& meaning = find<QLabel>(page, "earlierMeaning");
        QCOMPARE(reach.currentText(), QStringLiteral("This network"));
        QCOMPARE(meaning.text(), reachMeaning(SessionReach::Network));
        QVERIFY(meaning.isVisible());
        const QSignalSpy resumed{&page, &StartPage::resumeWanted};
        const auto resumes = [&](SessionReach whom) {
            find<QPushButton>(page, "resume").click();
            return resumed.last()[0].toString() == late
                   && resumed.last()[1].value<SessionReach>() == whom;
        };
        QVERIFY(resumes(SessionReach::Network)); // for those who were in it
        find<QRadioButton>(page, "byLink").click();
        QVERIFY(page.plan().reach == SessionReach::ByLink);
        QVERIFY(resumes(SessionReach::Network)); // that is of a new one
        reach.setFocus();
        QTest::keyClick(&reach, Qt::Key_Down);
        QCOMPARE(reach.currentText(), QStringLiteral("By link"));
        QCOMPARE(meaning.text(), reachMeaning(SessionReach::ByLink));
        QVERIFY(resumes(SessionReach::ByLink)); // a person said so
        stored.read();
        QVERIFY(test::soon([&stored] { return stored.isComplete(); }));
        QVERIFY(resumes(SessionReach::ByLink));
        Q_EMIT list.clicked(list.currentIndex()); // the same again changes nothing
        QVERIFY(resumes(SessionReach::ByLink));
    }

    void showsEarlierSessionsWholeWithoutScrolling()
    {
        const char* name = "Mammoth Winter Workshop, Mammoth Winter Workshop, Mammoth Winter";
        const test::ScratchFolder folder;
        storeSession(folder.filePath("session-20260102-101112-000.sqlite"), name,
                     SessionReach::Network);
        StoredSessionsModel stored{folder.path()};
        PlannedPatient patient{AnatomyCache::defaultFolder()};
        StartPage page{
            stored,
            patient,
            {.name = QStringLiteral("Ward 3"), .patient = QStringLiteral("child")},
            [](const QString&, const PatientModel*) { return std::vector<ReadyLine>{}; }};
        page.resize(1280, 800);
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        QVERIFY(test::soon([&stored] { return stored.isComplete() && stored.rowCount() == 1; }));
        const auto& list = find<QListView>(page, "earlier");
        const QModelIndex session = stored.index(0);
        const int line = list.fontMetrics().lineSpacing();
        QVERIFY(test::soon([&] { return list.visualRect(session).height() >= 2 * line; }));
        QVERIFY(list.visualRect(session).width() <= list.viewport()->width());
        QCOMPARE(list.horizontalScrollBar()->maximum(), 0);
        QVERIFY(session.data(Qt::ToolTipRole).toString().contains(QLatin1String{name}));
    }

    /// As when it could not be resumed, after which all are read anew.
    void keepsTheEarlierSessionThatAPersonChose()
    {
        const test::ScratchFolder folder;
        storeSession(folder.filePath("session-20260102-101112-000.sqlite"), "Early",
                     SessionReach::Network);
        storeSession(folder.filePath("session-20260103-101112-000.sqlite"), "Late",
                     SessionReach::Network);
        StoredSessionsModel stored{folder.path()};
        PlannedPatient patient{AnatomyCache::defaultFolder()};
        StartPage page{
            stored,
            patient,
            {.patient = QStringLiteral("child"), .reach = SessionReach::ByLink},
            [](const QString&, const PatientModel*) { return std::vector<ReadyLine>{}; }};
        QVERIFY(test::soon([&stored] { return stored.isComplete(); }));
        auto& list = find<QListView>(page, "earlier");
        QVERIFY(list.currentIndex().data().toString().contains(QStringLiteral("Late")));
        const QSignalSpy resumed{&page, &StartPage::resumeWanted};
        find<QPushButton>(page, "resume").click();
        QVERIFY(resumed.last()[1].value<SessionReach>() == SessionReach::ByLink); // as started
        list.setCurrentIndex(stored.index(1));
        stored.read();
        QVERIFY(test::soon([&stored] { return stored.isComplete(); }));
        QVERIFY(list.currentIndex().data().toString().contains(QStringLiteral("Early")));
        find<QPushButton>(page, "resume").click();
        QVERIFY(resumed.last()[1].value<SessionReach>() == SessionReach::Network); // as it was
        QVERIFY(page.plan().reach == SessionReach::ByLink);
    }

    /// In the order in which they are read: who can join stands above what begins the session.
    void asksWhoCanJoinBeforeItBegins()
    {
        Shown shown;
        QVERIFY(shown.isMade());
        shown.page.show();
        const auto top = [&shown](const char* name) {
            return find<QWidget>(shown.page, name).mapTo(&shown.page, QPoint{}).y();
        };
        QVERIFY(top("network") < top("begin"));
        QStringList path;
        find<QRadioButton>(shown.page, "thisComputer").setFocus();
        for (QWidget* at = shown.page.focusWidget(); at->objectName() != QStringLiteral("begin");
             at = shown.page.focusWidget()) {
            QVERIFY(path.size() < 20);
            path += at->objectName();
            QTest::keyClick(at, Qt::Key_Tab);
        }
        QVERIFY2(path.contains(QStringLiteral("name")), qPrintable(path.join(QLatin1Char{' '})));
    }

    void afterTheEndThereIsAnother()
    {
        EndPage page{{{QStringLiteral("Session"), QStringLiteral("Ward 3")}}};
        page.show();
        QSignalSpy another{&page, &EndPage::anotherWanted};
        find<QPushButton>(page, "another").click();
        QCOMPARE(another.size(), 1);
        QVERIFY(page.isVisible());
        find<QPushButton>(page, "close").click();
        QVERIFY(!page.isVisible());
    }

    void closingASessionAsks_data()
    {
        QTest::addColumn<QByteArray>("button");
        QTest::addColumn<int>("leaving");
        QTest::newRow("stay") << QByteArray{"stay"} << int(Leaving::Stay);
        QTest::newRow("close") << QByteArray{"closeForNow"} << int(Leaving::CloseForNow);
        QTest::newRow("start page") << QByteArray{"toStartPage"} << int(Leaving::ToStartPage);
        QTest::newRow("end") << QByteArray{"endForAll"} << int(Leaving::EndForAll);
    }

    void closingASessionAsks()
    {
        QFETCH(const QByteArray, button);
        QFETCH(const int, leaving);
        answerWith(button.constData());
        QCOMPARE(int(askBeforeLeaving(QStringLiteral("Tom: in the session"), true, nullptr)),
                 leaving);
    }
};

CARINA_SCREEN_TEST(TestStartPage)

} // namespace carina::start_page_test

#include "tst_start_page.moc"
