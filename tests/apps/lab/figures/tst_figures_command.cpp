#include "apps/lab/command/csv_table.h"
#include "apps/lab/commands.h"
#include "apps/lab/figures/drift_figure.h"
#include "apps/lab/figures/paper_values.h"
#include "engine/core/units.h"
#include "evaluation/drift/drift_experiment.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace carina::lab::figures_command_test
{
namespace
{

constexpr int kActions = 8;
constexpr std::uint32_t kSeed = 3;
constexpr double kRoundingError = 1e-12; ///< deg
/// A mean over samples of 1 ms may be so little below that over time, at delays of a few samples.
constexpr double kSampling = 0.5;

QStringList wordsFor(const QString& folder)
{
    return QStringLiteral("--scenario wan --actions 8 --seed 3 --seeds 1 --out")
               .split(QLatin1Char{' '})
           + QStringList{folder};
}

DriftFigures experimentOf(const char* strategy, std::uint16_t participants, double speed)
{
    DriftSettings settings;
    settings.strategy = findSyncStrategy(strategy);
    settings.participants = participants;
    settings.script = {
        .actions = kActions, .angularSpeed = degrees(speed).si, .speed = millimetres(speed).si};
    settings.scenario = *findScenario("wan");
    settings.seed = kSeed;
    return runDrift(settings, 1);
}

QByteArray bytesOf(const QString& path)
{
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
}

/// Lines of the series in an SVG file; -1 where it is no XML.
int polylinesIn(const QString& path)
{
    QXmlStreamReader xml{bytesOf(path)};
    int count = 0;
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement
            && xml.name() == QStringLiteral("polyline"))
            ++count;
    return xml.hasError() ? -1 : count;
}

} // namespace

class FiguresCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        const auto object = figuresCommand().run(wordsFor(m_folder.path()));
        QVERIFY(object);
        m_object = *object;
    }

    void namesItsFigures()
    {
        QCOMPARE(m_object[QLatin1StringView{"schema"}].toString(),
                 QStringLiteral("carina.figures/1"));
        QCOMPARE(m_object[QLatin1StringView{"version"}].toString(), QStringLiteral(CARINA_VERSION));
        QCOMPARE(m_object[QLatin1StringView{"seed"}].toInt(), int(kSeed));
        QCOMPARE(m_object[QLatin1StringView{"seeds"}].toInt(), 1);
        QStringList names;
        for (const QJsonValue& name : m_object[QLatin1StringView{"figures"}].toArray())
            names.append(name.toString());
        QStringList expected;
        for (const char* stem :
             {"drift-by-action-none", "drift-by-action-event", "drift-by-action-asa-adaptive",
              "drift-by-action-session-clock", "drift-by-participants-event",
              "drift-by-participants-asa-adaptive", "drift-by-participants-session-clock",
              "drift-by-delay"})
            for (const char* quantity : {"-orientation", "-position"})
                expected.append(QLatin1StringView{stem} + QLatin1StringView{quantity});
        QCOMPARE(names, expected);
        QStringList files{QStringLiteral("paper.csv"), QStringLiteral("trends.csv")};
        for (const QString& name : names)
            for (const char* ending : {".svg", ".png", ".csv"})
                files.append(name + QLatin1StringView{ending});
        files.sort();
        QCOMPARE(QDir{m_folder.path()}.entryList(QDir::Files, QDir::Name), files);
    }

    void eachCurveIsALineOfItsDrawing_data()
    {
        QTest::addColumn<QString>("figure");
        QTest::addColumn<int>("curves");
        QTest::newRow("by action") << QStringLiteral("drift-by-action-none-position") << 1;
        QTest::newRow("by participants")
            << QStringLiteral("drift-by-participants-event-orientation") << 4;
        QTest::newRow("by delay") << QStringLiteral("drift-by-delay-orientation")
                                  << int(syncStrategies().size()) + 1;
    }
    void eachCurveIsALineOfItsDrawing()
    {
        QFETCH(QString, figure);
        QFETCH(int, curves);
        const QString svg = m_folder.filePath(figure + QStringLiteral(".svg"));
        QCOMPARE(polylinesIn(svg), curves);
        const QByteArray stamp = "Carina " CARINA_VERSION ", network ";
        QVERIFY(bytesOf(svg).contains(stamp));
        QVERIFY(bytesOf(svg).contains("seed 3"));
    }

    void tableByActionIsTheExperiment()
    {
        const auto angles = CsvTable::read(
            m_folder.filePath(QStringLiteral("drift-by-action-event-orientation.csv")),
            {"version", "seed", "seeds", "network", "action", "orientation_deg"});
        const auto distances =
            CsvTable::read(m_folder.filePath(QStringLiteral("drift-by-action-event-position.csv")),
                           {"position_mm"});
        QVERIFY(angles && distances);
        const DriftFigures experiment = experimentOf("event", 2, 100.0);
        QCOMPARE(angles->rows(), experiment.actions.size());
        QCOMPARE(distances->rows(), experiment.actions.size());
        for (std::size_t i = 0; i < experiment.actions.size(); ++i) {
            QCOMPARE(angles->text(i, 0), QStringLiteral(CARINA_VERSION));
            QCOMPARE(angles->text(i, 1), QStringLiteral("3"));
            QCOMPARE(angles->text(i, 2), QStringLiteral("1"));
            QCOMPARE(angles->text(i, 3), QStringLiteral("wan"));
            QCOMPARE(*angles->number(i, 4), double(i + 1));
            QCOMPARE(*angles->number(i, 5), inDegrees(radians(experiment.actions[i].angle)));
            QCOMPARE(*distances->number(i, 0),
                     inMillimetres(metres(experiment.actions[i].distance)));
        }
    }

    void lineByParticipantsIsTheRegressionOfTheExperiments()
    {
        const auto trends =
            CsvTable::read(m_folder.filePath(QStringLiteral("trends.csv")),
                           {"figure", "curve", "order", "coefficient_0", "coefficient_1", "psi_1",
                            "psi_2", "psi_3", "psi_4", "psi_5"});
        QVERIFY(trends);
        QCOMPARE(trends->rows(), std::size_t{4 * 2 + 3 * 2 * 4});
        std::size_t row = 0;
        while (trends->text(row, 0)
                   != QStringLiteral("drift-by-participants-asa-adaptive-orientation")
               || trends->text(row, 1) != QStringLiteral("50 deg/s"))
            ++row;
        QCOMPARE(trends->text(row, 2), QStringLiteral("1"));
        // Slope and mean of five even steps, written out.
        double slope = 0.0;
        double mean = 0.0;
        for (int i = 0; i < 5; ++i) {
            const double psi = *trends->number(row, 5 + std::size_t(i));
            const auto participants = static_cast<std::uint16_t>(i + 2);
            QCOMPARE(psi,
                     inDegrees(radians(experimentOf("asa-adaptive", participants, 50.0).atEvent)));
            slope += (i - 2) * psi / 10.0;
            mean += psi / 5.0;
        }
        QVERIFY(std::abs(*trends->number(row, 4) - slope) < kRoundingError);
        QVERIFY(std::abs(*trends->number(row, 3) - (mean - 4.0 * slope)) < kRoundingError);
    }

    void noStrategyIsBelowTheLimit()
    {
        const auto table =
            CsvTable::read(m_folder.filePath(QStringLiteral("drift-by-delay-orientation.csv")),
                           {"curve", "delay_ms", "orientation_deg"});
        QVERIFY(table);
        const std::size_t delays = table->rows() / (syncStrategies().size() + 1);
        const std::size_t firstLimit = table->rows() - delays;
        QCOMPARE(table->text(firstLimit, 0), QStringLiteral("limit until heard"));
        for (std::size_t row = 0; row < firstLimit; ++row) {
            const std::size_t limit = firstLimit + row % delays;
            QCOMPARE(table->text(row, 1), table->text(limit, 1));
            if (table->text(row, 0) == QStringLiteral("local-lag"))
                continue; // of which the limit does not hold: the actor waits too
            QVERIFY2(*table->number(row, 2) > kSampling * *table->number(limit, 2),
                     qPrintable(table->text(row, 0) + QLatin1Char{' '} + table->text(row, 1)));
        }
    }

    void rawAngleIsThatOfThePaper()
    {
        FigureSettings settings;
        settings.scenario = *findScenario("wan");
        settings.seed = kSeed;
        settings.source = virtualDrift(1);
        settings.actions = kActions;
        settings.isAngleRaw = true;
        const auto figures = figuresByAction(settings);
        QVERIFY(figures);
        const DriftFigure& none = figures->front();
        QCOMPARE(none.name, std::string{"drift-by-action-none-orientation"});
        QCOMPARE(none.yColumn, std::string{"raw_angle_deg"});
        QVERIFY(none.yLabel.starts_with("2 acos(w) as in 2004"));
        QVERIFY(none.isAngleRaw && !figures->at(2).isAngleRaw);
        QCOMPARE(figures->at(2).yColumn, std::string{"orientation_deg"});
        const DriftFigures experiment = experimentOf("none", 2, 100.0);
        for (std::size_t i = 0; i < experiment.actions.size(); ++i)
            QCOMPARE(none.curves[0].y[i], inDegrees(radians(experiment.actions[i].rawAngle)));
    }

    void paperStandsBesideOurs()
    {
        const auto table = CsvTable::read(m_folder.filePath(QStringLiteral("paper.csv")),
                                          {"paper_figure", "paper_printed", "measured", "order",
                                           "source", "quantity", "paper_trend"});
        QVERIFY(table);
        // As printed in 2004; none for 3, 4 and 5 participants, and none in figure 12.
        const std::array<std::array<const char*, 2>, 7> printed{{{"9", "above 210"},
                                                                 {"10", "11"},
                                                                 {"11", "2.83"},
                                                                 {"12", ""},
                                                                 {"12", ""},
                                                                 {"13", "2.83"},
                                                                 {"13", "3.17"}}};
        QCOMPARE(table->rows(), printed.size());
        for (std::size_t row = 0; row < printed.size(); ++row) {
            QCOMPARE(table->text(row, 0), QString::fromLatin1(printed[row][0]));
            QCOMPARE(table->text(row, 1), QString::fromLatin1(printed[row][1]));
            QVERIFY(table->text(row, 4).contains(QStringLiteral("2004")));
            QVERIFY(table->text(row, 5).startsWith(QStringLiteral("drift: ")));
            QCOMPARE(table->text(row, 6) == QStringLiteral("linear regression"), row >= 3);
        }
        QCOMPARE(*table->number(0, 3), double{kTrendOfNone});
        const auto meanOf = [](const char* strategy, std::uint16_t participants) {
            return inDegrees(radians(experimentOf(strategy, participants, 100.0).atEvent));
        };
        QVERIFY(std::abs(*table->number(2, 2) - meanOf("asa-adaptive", 2)) < kRoundingError);
        QCOMPARE(*table->number(3, 2), meanOf("event", 2));
        QCOMPARE(*table->number(4, 2), meanOf("event", 6));
        QCOMPARE(*table->number(5, 2), meanOf("asa-adaptive", 2));
        QCOMPARE(*table->number(6, 2), meanOf("asa-adaptive", 6));
    }

    void paperStandsBesideWhatItsAngleIs()
    {
        DriftFigure none;
        none.name = "drift-by-action-none-orientation";
        none.curves = {DriftCurve{.name = "none", .x = {1.0, 2.0}, .y = {11.0, 349.0}}};
        for (const bool isRaw : {true, false}) {
            none.isAngleRaw = isRaw;
            const auto values = besidePaper(std::span{&none, 1});
            QCOMPARE(values.size(), std::size_t{1});
            QCOMPARE(values[0].quantity,
                     std::string{isRaw ? "2 acos(w)" : "drift"} + ": greatest of an action");
            QCOMPARE(values[0].printed, std::string{"above 210"});
            QCOMPARE(values[0].measured, 349.0);
        }
    }

    void announcesEveryCurve()
    {
        FigureSettings settings;
        settings.source = virtualDrift(1);
        settings.actions = kActions;
        std::size_t curves = 0;
        settings.onCurve = [&curves](const std::string&) { ++curves; };
        QVERIFY(figuresByAction(settings));
        QVERIFY(figuresByParticipants(settings));
        QVERIFY(figuresByDelay(settings));
        QCOMPARE(curves, curvesToMeasure(settings.source));
    }

    void drawsEveryStrategyLive()
    {
        const DriftSource source = liveDrift(allStrategies(), {});
        QCOMPARE(source.byAction.size(), syncStrategies().size());
        for (const SyncStrategy& strategy : syncStrategies())
            for (const auto* drawn : {&source.byAction, &source.byParticipants, &source.byDelay})
                QVERIFY(std::ranges::count(*drawn, strategy.name) == 1);
    }

    void refusesWhatItDoesNotUnderstand_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("named");
        const auto row = [](const char* name, const char* words, const char* named) {
            QTest::newRow(name) << QString::fromLatin1(words) << QString::fromLatin1(named);
        };
        row("no folder", "--seed 1", "--out DIR is missing");
        row("an option there is not", "--out x --dead", "dead");
        row("seeds of a live session", "--out x --live --seeds 2", "--seeds");
        row("a warm-up of nothing", "--out x --warm-up-s 3", "--warm-up-s goes with --live");
        row("a strategy of nothing", "--out x --strategy event", "--strategy goes with --live");
        row("a strategy there is not", "--out x --live --strategy luck", "luck");
        row("too long a warm-up", "--out x --live --warm-up-s 301", "--warm-up-s");
        row("a word too many", "--out x yonder", "yonder");
        row("an option without its value", "--out x --seed", "--seed");
        row("too few actions for a trend", "--out x --actions 7", "--actions");
        row("no seeds", "--out x --seeds 0", "--seeds");
        row("negative seed", "--out x --seed -1", "--seed");
        row("unknown scenario", "--out x --scenario moon", "moon is neither");
        row("a folder that cannot be", "--out /dev/null/x", "/dev/null/x: nothing can be written");
        row("a folder that takes no file", "--out /proc", "/proc: nothing can be written");
    }
    void refusesWhatItDoesNotUnderstand()
    {
        QFETCH(QString, words);
        QFETCH(QString, named);
        const auto object = figuresCommand().run(words.split(QLatin1Char{' '}));
        QVERIFY(!object);
        QVERIFY2(QString::fromStdString(object.error().detail).contains(named),
                 object.error().detail.c_str());
    }

    void sameWordsSameBytes()
    {
        const QTemporaryDir again;
        QVERIFY(figuresCommand().run(wordsFor(again.path())));
        const QStringList names =
            QDir{again.path()}.entryList({QStringLiteral("*.csv"), QStringLiteral("*.svg")});
        QCOMPARE(names.size(), 16 * 2 + 2);
        for (const QString& name : names)
            QVERIFY2(bytesOf(again.filePath(name)) == bytesOf(m_folder.filePath(name)),
                     qPrintable(name));
    }

private:
    QTemporaryDir m_folder;
    QJsonObject m_object;
};

CARINA_SCREEN_TEST(FiguresCommandTest)

} // namespace carina::lab::figures_command_test

#include "tst_figures_command.moc"
