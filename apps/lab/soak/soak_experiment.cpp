#include "apps/lab/soak/soak_experiment.h"

#include "apps/lab/soak/log_memory.h"
#include "apps/lab/soak/soak_script.h"
#include "engine/core/monotonic_clock.h"

#include <QCoreApplication>
#include <QThread>

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr Duration kSampleInterval = std::chrono::seconds{1}; ///< of the footprints
constexpr double kNotMeasured = 0.1;                          ///< share of the time not measured
constexpr unsigned long kTurn_ms = 20;

/// The programs, and this one's own part in their session.
class Soak
{
public:
    explicit Soak(const SoakSettings& settings) : m_settings{settings} {}

    Result<SoakFigures> run()
    {
        if (const auto in = comeIn(); !in)
            return tl::unexpected(in.error());
        for (const auto& program : m_session->programs())
            m_figures.programs.push_back({.name = program->name()});
        const LocalTime begin = monotonicNow();
        LocalTime nextSample = begin + scaled(kNotMeasured);
        while (monotonicNow() < begin + m_settings.length) {
            QCoreApplication::processEvents();
            m_script->step(monotonicNow() - begin);
            if (const auto fault = faultNow())
                return tl::unexpected(*fault);
            if (monotonicNow() >= nextSample) {
                nextSample += kSampleInterval;
                sample(monotonicNow() - begin);
            }
            QThread::msleep(kTurn_ms);
        }
        m_script->report(m_figures);
        return measureLog().map([this] { return m_figures; });
    }

private:
    [[nodiscard]] Duration scaled(double share) const
    {
        return std::chrono::round<Duration>(share * m_settings.length);
    }

    [[nodiscard]] std::optional<Error> faultNow() const
    {
        const auto fault = m_session->fault();
        return fault ? fault : m_script->refusal();
    }

    Result<void> comeIn()
    {
        auto session = StartedSession::start(m_settings.programs);
        if (!session)
            return tl::unexpected(session.error());
        m_session = *std::move(session);
        auto script = SoakScript::of(m_settings, m_session->port(), m_session->codes());
        if (!script)
            return tl::unexpected(script.error());
        m_script = *std::move(script);
        return waitFor([&] { return m_script->isReady(); })
                   ? Result<void>{}
                   : fail(Errc::HostSilent, "console and trainee did not come in");
    }

    /// Ends the session, and measures what its log took in each of the programs.
    Result<void> measureLog()
    {
        m_script.reset();
        const auto log = m_session->end();
        if (!log)
            return tl::unexpected(log.error());
        const LogMemory memory = memoryOf(*log);
        const auto facts = static_cast<double>(std::max<std::size_t>(1, log->size()));
        m_figures.programs[0].bytesPerFact = memory.host_bytes / facts;
        m_figures.programs[1].bytesPerFact = memory.participant_bytes / facts;
        return {};
    }

    void sample(Duration since)
    {
        const double minutes = toSeconds(since) / 60.0;
        m_figures.facts.push_back({minutes, double(m_script->facts())});
        const auto& programs = m_session->programs();
        for (std::size_t i = 0; i < programs.size(); ++i) {
            const auto footprint = programs[i]->footprint();
            if (!footprint)
                continue;
            SoakedProgram& kept = m_figures.programs[i];
            kept.memory_kb.push_back({minutes, footprint->memory_kb});
            kept.descriptors.push_back({minutes, double(footprint->descriptors)});
            kept.threads.push_back({minutes, double(footprint->threads)});
        }
    }

    SoakSettings m_settings;
    std::unique_ptr<StartedSession> m_session;
    std::unique_ptr<SoakScript> m_script; // leaves before the programs end
    SoakFigures m_figures;
};

} // namespace

Result<SoakFigures> soak(const SoakSettings& settings) { return Soak{settings}.run(); }

} // namespace carina::lab
