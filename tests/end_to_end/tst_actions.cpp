#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <algorithm>
#include <numbers>

namespace carina::actions_test
{

namespace
{

constexpr double kSpeed_deg_per_s = 100.0; ///< that the console turns the patient at, about z
constexpr double kTolerance_deg = 0.01;    ///< clocks of 0.1 ms

double degreesFrom(double radians) { return radians * 180.0 / std::numbers::pi; }

/// A host sends an action before it has stored it, and stores it within 0.1 s and the disk's time.
constexpr qint64 kOnDiskAfter_ns = 3'000'000'000;

bool turns(const QJsonObject& line)
{
    const double rate = degreesFrom(line[QStringLiteral("patient_rate")].toDouble());
    return std::abs(rate - kSpeed_deg_per_s) < 1e-3;
}

/// How far the patient is turned about z.
double turned_deg(const QJsonObject& line)
{
    const QJsonArray q = line[QStringLiteral("patient_q_xyzw")].toArray();
    return degreesFrom(2.0 * std::atan2(q[2].toDouble(), q[3].toDouble()));
}

// A tongue that swells.
constexpr double kSwelling = 0.8;      ///< severity that it comes to
constexpr double kSwelling_s = 10.0;   ///< over this time
constexpr double kSameBegin_s = 0.001; ///< between programs

double swelling(const QJsonObject& line)
{
    return line[QStringLiteral("airway_events")]
        .toObject()[QStringLiteral("tongue_oedema")]
        .toDouble();
}

/// When it began, by each line that has it on the way.
std::vector<double> beginsOfSwelling_s(const Program& program)
{
    std::vector<double> begins;
    for (const QJsonObject& line : program.allShown())
        if (swelling(line) > 0.0 && swelling(line) < kSwelling)
            begins.push_back(1e-9 * double(line[QStringLiteral("session_ns")].toInteger())
                             - kSwelling_s * swelling(line) / kSwelling);
    return begins;
}

// A neck that is flexed.
constexpr double kFlexion_deg = 35.0; ///< that it comes to
constexpr double kLaying_s = 10.0;    ///< over this time

double flexion_deg(const QJsonObject& line)
{
    return line[QStringLiteral("head_position")]
        .toObject()[QStringLiteral("neck_flexion_deg")]
        .toDouble();
}

bool isFlexed(const QJsonObject& line)
{
    return std::abs(flexion_deg(line) - kFlexion_deg) < kTolerance_deg;
}

/// When that began, likewise; not near either end, where rounding counts.
std::vector<double> beginsOfLaying_s(const Program& program)
{
    std::vector<double> begins;
    for (const QJsonObject& line : program.allShown())
        if (flexion_deg(line) > 1.0 && flexion_deg(line) < kFlexion_deg - 1.0)
            begins.push_back(1e-9 * double(line[QStringLiteral("session_ns")].toInteger())
                             - kLaying_s * flexion_deg(line) / kFlexion_deg);
    return begins;
}

/// How far two lines are apart in what they say of one steady turn.
double apart_deg(const QJsonObject& a, const QJsonObject& b)
{
    const auto ns = [](const QJsonObject& line) {
        return line[QStringLiteral("session_ns")].toInteger();
    };
    const double expected = kSpeed_deg_per_s * 1e-9 * double(ns(b) - ns(a));
    return std::abs(std::remainder(turned_deg(b) - turned_deg(a) - expected, 360.0));
}

bool isInPlace(const QJsonObject& line)
{
    return line[QStringLiteral("patient_rate")].toDouble(1.0) == 0.0
           && line[QStringLiteral("patient_xyz_mm")].toArray() == QJsonArray{0.0, 0.0, 0.0}
           && line[QStringLiteral("patient_q_xyzw")].toArray() == QJsonArray{0.0, 0.0, 0.0, 1.0};
}

} // namespace

/// A script turns the virtual patient by the console's controls that a person would use.
class TestActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        const QString port = portOfThisTest();
        const QString codes = m_folder->filePath(QStringLiteral("codes"));
        const QStringList common{QStringLiteral("--port"),    port,
                                 QStringLiteral("--patient"), QStringLiteral("child"),
                                 QStringLiteral("--data"),    m_folder->path()};
        m_instructor =
            std::make_unique<Program>(QStringLiteral(CARINA_INSTRUCTOR),
                                      common + QStringList{QStringLiteral("--codes"), codes},
                                      m_folder->filePath(QStringLiteral("instructor.jsonl")));
        m_trainee = std::make_unique<Program>(
            QStringLiteral(CARINA_TRAINEE),
            common
                + QStringList{QStringLiteral("--as"), QStringLiteral("Trainee"),
                              QStringLiteral("--code-file"), codes},
            m_folder->filePath(QStringLiteral("trainee.jsonl")));
        m_script = std::make_unique<QFile>(m_folder->filePath(QStringLiteral("script")));
        QVERIFY(m_script->open(QIODevice::WriteOnly));
        m_instructor->start(
            {QStringLiteral("--start"), QStringLiteral("--script"), m_script->fileName()});
        m_trainee->start();
        QTRY_VERIFY_WITH_TIMEOUT(!m_trainee->shown().isEmpty(), kPatience_ms);
        work({"type speed 100", "press begin"});
        QTRY_VERIFY_WITH_TIMEOUT(turns(m_trainee->shown()) && turns(m_instructor->shown()),
                                 kPatience_ms);
    }

    void cleanup()
    {
        m_trainee.reset();
        m_instructor.reset();
        m_script.reset();
    }

    void bothShowTheSameTurnAndBothPutItBack()
    {
        QVERIFY(apart_deg(m_instructor->shown(), m_trainee->shown()) < kTolerance_deg);
        work({"press stop", "press reset"});
        QTRY_VERIFY_WITH_TIMEOUT(isInPlace(m_instructor->shown()), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(isInPlace(m_trainee->shown()), kPatience_ms);
    }

    /// As severe at each session time at both, also while it comes.
    void tongueSwellsAtBothAtOnceAndIsWellAgainByAnUndo()
    {
        work({"type airwayOver 10", "type tongue_oedema 80"});
        const auto isSwollen = [](const Program& program) {
            return swelling(program.shown()) == kSwelling;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isSwollen(*m_instructor) && isSwollen(*m_trainee), kPatience_ms);
        std::vector<double> begins_s = beginsOfSwelling_s(*m_instructor);
        const std::vector<double> atTrainee_s = beginsOfSwelling_s(*m_trainee);
        QVERIFY(!begins_s.empty() && !atTrainee_s.empty());
        begins_s.insert(begins_s.end(), atTrainee_s.begin(), atTrainee_s.end());
        const auto [first, last] = std::ranges::minmax(begins_s);
        QVERIFY2(last - first < kSameBegin_s, qPrintable(QString::number(last - first)));
        work({"press undoChange"});
        QTRY_VERIFY_WITH_TIMEOUT(swelling(m_instructor->shown()) == 0.0, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(swelling(m_trainee->shown()) == 0.0, kPatience_ms);
    }

    /// Flexed as far at each session time at both, also while it is laid so.
    void headIsLaidAtBothAtOnceAndBackByAnUndo()
    {
        work({"type airwayOver 10", "choose headPosition Flexed"});
        QTRY_VERIFY_WITH_TIMEOUT(isFlexed(m_instructor->shown()) && isFlexed(m_trainee->shown()),
                                 kPatience_ms);
        std::vector<double> begins_s = beginsOfLaying_s(*m_instructor);
        const std::vector<double> atTrainee_s = beginsOfLaying_s(*m_trainee);
        QVERIFY(!begins_s.empty() && !atTrainee_s.empty());
        begins_s.insert(begins_s.end(), atTrainee_s.begin(), atTrainee_s.end());
        const auto [first, last] = std::ranges::minmax(begins_s);
        QVERIFY2(last - first < kSameBegin_s, qPrintable(QString::number(last - first)));
        work({"press undoChange"});
        QTRY_VERIFY_WITH_TIMEOUT(flexion_deg(m_instructor->shown()) == 0.0, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(flexion_deg(m_trainee->shown()) == 0.0, kPatience_ms);
    }

    void turnGoesOnWhenBothWereKilledInIt()
    {
        const QJsonObject before = m_trainee->shown();
        const auto shownFor_ns = [&] {
            const QString now = QStringLiteral("session_ns");
            return m_instructor->shown()[now].toInteger() - before[now].toInteger();
        };
        QTRY_VERIFY_WITH_TIMEOUT(shownFor_ns() > kOnDiskAfter_ns, kPatience_ms);
        m_instructor->kill();
        m_trainee->kill();
        m_instructor->start(); // and nobody stops it
        m_trainee->start();
        QTRY_VERIFY_WITH_TIMEOUT(turns(m_instructor->shown()), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(turns(m_trainee->shown()), kPatience_ms);
        QVERIFY(apart_deg(before, m_instructor->shown()) < kTolerance_deg);
        QVERIFY(apart_deg(before, m_trainee->shown()) < kTolerance_deg);
    }

private:
    /// Appends lines to the console's script.
    void work(std::initializer_list<const char*> lines)
    {
        for (const char* line : lines)
            m_script->write(QByteArray{line} + '\n');
        QVERIFY(m_script->flush());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<QFile> m_script;
    std::unique_ptr<Program> m_instructor;
    std::unique_ptr<Program> m_trainee;
};

CARINA_TEST(TestActions)

} // namespace carina::actions_test

#include "tst_actions.moc"
