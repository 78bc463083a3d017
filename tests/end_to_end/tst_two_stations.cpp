#include "engine/anatomy/patient/patient_name.h"
#include "engine/net/node/session_node.h"
#include "engine/session/station_rules.h"
#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QTemporaryDir>

namespace carina::two_stations_test
{

namespace
{

constexpr int kSoon_ms = 10'000; ///< for a patient to be made and laid

QString anatomyOf(BuiltinPatient patient)
{
    return QString::fromStdString(madeHash(parametersOf(patient)));
}

QString textOf(const Program& program, const char* key)
{
    return program.shown()[QLatin1String{key}].toString();
}

bool isAt(const Program& program, const QString& station, BuiltinPatient patient)
{
    return textOf(program, "station") == station
           && textOf(program, "anatomy") == anatomyOf(patient);
}

} // namespace

/// A console with two stations, with a child and with an adult, and a trainee at each.
class TestTwoStations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        m_instructor = std::make_unique<Program>(
            QStringLiteral(CARINA_INSTRUCTOR),
            QStringList{QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--patient"),
                        QStringLiteral("child"), QStringLiteral("--add-station"),
                        QStringLiteral("Room 5: adult"), QStringLiteral("--data"), m_folder.path(),
                        QStringLiteral("--codes"), codes()},
            m_folder.filePath(QStringLiteral("instructor.jsonl")));
        m_instructor->start({QStringLiteral("--start")});
        m_anna = trainee("Anna", {});
        m_ben = trainee("Ben", {QStringLiteral("--station"), QStringLiteral("room 5")});
        m_anna->start();
        QTRY_VERIFY_WITH_TIMEOUT(isAt(*m_anna, m_first, BuiltinPatient::TwelveYears), kPatience_ms);
        m_ben->start();
        QTRY_VERIFY_WITH_TIMEOUT(isAt(*m_ben, m_room, BuiltinPatient::Adult), kPatience_ms);
    }

    void cleanupTestCase()
    {
        m_ben.reset();
        m_anna.reset();
        m_instructor.reset();
    }

    void consoleShowsItsOwnStation()
    {
        QVERIFY(isAt(*m_instructor, m_first, BuiltinPatient::TwelveYears));
    }

    void stationThatIsNotThereIsRefused()
    {
        auto zoe = trainee("Zoe", {QStringLiteral("--station"), QStringLiteral("Room 6"),
                                   QStringLiteral("--measure"),
                                   m_folder.filePath(QStringLiteral("measured")),
                                   QStringLiteral("--seconds"), QStringLiteral("3")});
        zoe->start();
        QTRY_VERIFY_WITH_TIMEOUT(zoe->hasEnded(), kPatience_ms);
        QCOMPARE(zoe->exitCode(), 1);
    }

    void traineeIsMovedAndEveryPatientChanged()
    {
        const auto node = secondInstructor();
        QTRY_VERIFY_WITH_TIMEOUT(node && node->self() != kNobody && idOf(*node, "Ben"), kSoon_ms);
        node->propose(kAllStations, fact::BreathingRateSet{perMinute(31.0)});
        for (const Program* program : {m_anna.get(), m_ben.get(), m_instructor.get()})
            QTRY_COMPARE_WITH_TIMEOUT(
                program->shown()[QStringLiteral("breathing_rate_per_min")].toDouble(), 31.0,
                kSoon_ms);
        node->propose(*openStationNamed(*node->state(), "Station 1"),
                      fact::ParticipantMoved{*idOf(*node, "Ben")});
        QTRY_VERIFY_WITH_TIMEOUT(isAt(*m_ben, m_first, BuiltinPatient::TwelveYears), kSoon_ms);
        QVERIFY(isAt(*m_anna, m_first, BuiltinPatient::TwelveYears));
        // Where he was last, and not where his first command line said.
        m_ben->kill();
        m_ben = trainee("Ben", {});
        m_ben->start();
        QTRY_VERIFY_WITH_TIMEOUT(isAt(*m_ben, m_first, BuiltinPatient::TwelveYears), kPatience_ms);
    }

private:
    [[nodiscard]] QString codes() const { return m_folder.filePath(QStringLiteral("codes")); }

    [[nodiscard]] std::unique_ptr<Program> trainee(const char* name, const QStringList& more) const
    {
        return std::make_unique<Program>(
            QStringLiteral(CARINA_TRAINEE),
            QStringList{QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--as"),
                        QLatin1String{name}, QStringLiteral("--tracker"),
                        QStringLiteral("simulated"), QStringLiteral("--data"), m_folder.path(),
                        QStringLiteral("--code-file"), codes()}
                + more,
            m_folder.filePath(QLatin1String{name} + QStringLiteral(".jsonl")));
    }

    [[nodiscard]] std::unique_ptr<SessionNode> secondInstructor() const
    {
        QFile file{codes()};
        if (!file.open(QIODevice::ReadOnly))
            return nullptr;
        for (const QByteArray& line : file.readAll().split('\n')) {
            const auto code =
                JoinCode::parse(line.mid(line.indexOf(' ') + 1).trimmed().toStdString());
            if (!line.startsWith("instructor ") || !code)
                continue;
            auto node = SessionNode::join({.port = portOfThisTest().toUShort(),
                                           .participantName = "Dr Rolland",
                                           .role = Role::Instructor,
                                           .code = *code});
            return node ? *std::move(node) : nullptr;
        }
        return nullptr;
    }

    [[nodiscard]] static std::optional<ParticipantId> idOf(const SessionNode& node,
                                                           const std::string& name)
    {
        const auto state = node.state();
        for (const auto& [id, participant] : state->participants())
            if (participant.name == name)
                return id;
        return std::nullopt;
    }

    const QString m_first = QStringLiteral("Station 1");
    const QString m_room = QStringLiteral("Room 5");
    QTemporaryDir m_folder;
    std::unique_ptr<Program> m_instructor;
    std::unique_ptr<Program> m_anna;
    std::unique_ptr<Program> m_ben;
};

CARINA_TEST(TestTwoStations)

} // namespace carina::two_stations_test

#include "tst_two_stations.moc"
