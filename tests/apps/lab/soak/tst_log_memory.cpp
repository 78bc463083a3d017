#include "apps/lab/soak/log_memory.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/session/respiration/patient_run.h"
#include "tests/engine/session/facts/sample_session.h"
#include "tests/support/test_class.h"

namespace carina::log_memory_test
{
namespace
{

using namespace carina::lab;
using namespace carina::test;

/// A session with so many more facts of a kind.
std::vector<FactRecord> logWith(int facts, const std::function<FactBody(int)>& next)
{
    LogWriter writer = sampleSession();
    for (int i = 1; i <= facts; ++i)
        writer.add(atSeconds(10.0 * i), next(i));
    std::vector<FactRecord> log;
    for (const Fact& fact : writer.log())
        log.push_back(toRecord(fact));
    return log;
}

} // namespace

class TestLogMemory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void countsRecordsAndState()
    {
        const auto rate = [](int i) -> FactBody {
            return fact::BreathingRateSet{perMinute(10.0 + i % 10)};
        };
        // A change of a rate, and at the host the record besides.
        constexpr double kState = sizeof(ParameterTimeline<Frequency>::Change);
        const LogMemory few = memoryOf(logWith(1 << 10, rate));
        const LogMemory many = memoryOf(logWith(1 << 12, rate));
        constexpr double kMore = (1 << 12) - (1 << 10);
        const double participant = (many.participant_bytes - few.participant_bytes) / kMore;
        const double host = (many.host_bytes - few.host_bytes) / kMore;
        QVERIFY2(participant > 1.9 * kState && participant < 4.0 * kState,
                 qPrintable(QString::number(participant)));
        QVERIFY2(host > 2.9 * kState + sizeof(FactRecord), qPrintable(QString::number(host)));
        QVERIFY2(host < 640.0, qPrintable(QString::number(host))); // bytes
    }

    /// A session that runs for days has one every ten seconds.
    void checkpointsTakeNothingAtAParticipant()
    {
        const SessionState state = stateOf(sampleSession());
        const PatientRun run{timelineOf(state), atSeconds(0.0)};
        const auto parts = run.checkpoint();
        const auto checkpoint = [&](int i) {
            FactBody part = parts[std::size_t(i) % parts.size()];
            const SessionTime at = atSeconds(30.0 * (i / int(parts.size())));
            std::visit(
                [at](auto& body) {
                    if constexpr (requires { body.at; })
                        body.at = at;
                },
                part);
            return part;
        };
        const LogMemory few = memoryOf(logWith(1000, checkpoint));
        const LogMemory many = memoryOf(logWith(8000, checkpoint));
        constexpr double kMore = 7000.0;
        constexpr double kNothing = 1.0; // bytes for each
        QVERIFY((many.participant_bytes - few.participant_bytes) / kMore < kNothing);
        QVERIFY((many.host_bytes - few.host_bytes) / kMore > sizeof(FactRecord));
    }
};

CARINA_TEST(TestLogMemory)

} // namespace carina::log_memory_test

#include "tst_log_memory.moc"
