#include "apps/lab/soak/soak_experiment.h"

#include "apps/lab/soak/soak_script.h"
#include "apps/lab/soak/watched_program.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/files/whole_file.h"
#include "engine/net/entry/psk_identity.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QThread>
#include <QUdpSocket>

#include <functional>

namespace carina::lab
{
namespace
{

constexpr Duration kPatience = std::chrono::seconds{60};      ///< for coming in
constexpr Duration kSampleInterval = std::chrono::seconds{1}; ///< of the footprints
constexpr double kSettling = 0.1;                             ///< share of the time not measured
constexpr unsigned long kTurn_ms = 20;

std::uint16_t freePort()
{
    QUdpSocket probe;
    probe.bind(QHostAddress::LocalHost);
    return probe.localPort();
}

/// Works the event loop until something holds. @returns whether it came to hold
bool waitFor(const std::function<bool()>& holds)
{
    const LocalTime deadline = monotonicNow() + kPatience;
    while (!holds() && monotonicNow() < deadline) {
        QCoreApplication::processEvents();
        QThread::msleep(kTurn_ms);
    }
    return holds();
}

Result<JoinCodes> codesIn(const QString& file)
{
    if (!waitFor([&] { return QFile::exists(file); }))
        return fail(Errc::HostSilent, "the console wrote no codes");
    const auto text = readWholeFile(file.toStdString());
    if (!text)
        return tl::unexpected(text.error());
    JoinCodes codes;
    for (const QString& line : QString::fromStdString(*text).split(QLatin1Char('\n'))) {
        const auto role = roleOfWord(line.section(QLatin1Char(' '), 0, 0).toStdString());
        const auto code = JoinCode::parse(line.section(QLatin1Char(' '), 1).toStdString());
        if (role && code)
            codes.emplace(*role, *code);
    }
    return codes;
}

/// The programs, and this one's own part in their session.
class Soak
{
public:
    explicit Soak(const SoakSettings& settings)
        : m_settings{settings},
          m_port{freePort()},
          m_codes{m_folder.filePath(QStringLiteral("codes"))}
    {
    }

    Result<SoakFigures> run()
    {
        if (const auto in = comeIn(); !in)
            return tl::unexpected(in.error());
        for (const auto& program : m_programs)
            m_figures.programs.push_back({program->name(), {}, {}, {}});
        const LocalTime begin = monotonicNow();
        LocalTime nextSample = begin + scaled(kSettling);
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
        return m_figures;
    }

private:
    [[nodiscard]] Duration scaled(double share) const
    {
        return std::chrono::round<Duration>(share * m_settings.length);
    }

    [[nodiscard]] std::optional<Error> faultNow() const
    {
        for (const auto& program : m_programs)
            if (program->hasEnded())
                return Error{Errc::HostSilent, "the " + program->name() + " ended before the time"};
        return m_script->refusal();
    }

    [[nodiscard]] QStringList words(const QString& program, const QStringList& more) const
    {
        return QStringList{program, QStringLiteral("--port"), QString::number(m_port),
                           QStringLiteral("--data"), m_folder.path()}
               + more;
    }

    Result<void> comeIn()
    {
        for (const QString& program : {m_settings.console, m_settings.trainee})
            if (!QFile::exists(program))
                return fail(Errc::FileNotFound, program.toStdString());
        start("console",
              words(m_settings.console, {QStringLiteral("--new"), QStringLiteral("--start"),
                                         QStringLiteral("--codes"), m_codes}));
        const auto codes = codesIn(m_codes);
        if (!codes)
            return tl::unexpected(codes.error());
        start("trainee",
              words(m_settings.trainee, {QStringLiteral("--as"), QStringLiteral("Trainee"),
                                         QStringLiteral("--simulated-tracker"),
                                         QStringLiteral("--code-file"), m_codes}));
        auto script = SoakScript::of(m_settings, m_port, *codes);
        if (!script)
            return tl::unexpected(script.error());
        m_script = *std::move(script);
        return waitFor([&] { return m_script->isReady(); })
                   ? Result<void>{}
                   : fail(Errc::HostSilent, "console and trainee did not come in");
    }

    void start(const char* name, const QStringList& words)
    {
        m_programs.push_back(std::make_unique<WatchedProgram>(name, words));
    }

    void sample(Duration since)
    {
        const double minutes = toSeconds(since) / 60.0;
        for (std::size_t i = 0; i < m_programs.size(); ++i) {
            const auto footprint = m_programs[i]->footprint();
            if (!footprint)
                continue;
            SoakedProgram& kept = m_figures.programs[i];
            kept.memory_kb.push_back({minutes, footprint->memory_kb});
            kept.descriptors.push_back({minutes, double(footprint->descriptors)});
            kept.threads.push_back({minutes, double(footprint->threads)});
        }
    }

    SoakSettings m_settings;
    QTemporaryDir m_folder;
    std::uint16_t m_port;
    QString m_codes; ///< file
    std::vector<std::unique_ptr<WatchedProgram>> m_programs;
    std::unique_ptr<SoakScript> m_script; // leaves before they end
    SoakFigures m_figures;
};

} // namespace

Result<SoakFigures> soak(const SoakSettings& settings) { return Soak{settings}.run(); }

} // namespace carina::lab
