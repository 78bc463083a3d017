#include "engine/io/mesh/surface_reader.h"

#include "engine/io/mesh/mesh_file_codec.h"
#include "engine/sync/wire/byte_buffer.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QFileInfo>
#include <QProcess>

namespace carina
{
namespace
{

constexpr std::uint64_t kLongestAnswer = std::uint64_t{1} << 31;

/// Beside the running program as in a package, else where it was built.
QString readerProgram()
{
    const QString beside =
        QCoreApplication::applicationDirPath() + QStringLiteral("/carina-surface-reader");
    return QFileInfo::exists(beside) ? beside : QStringLiteral(CARINA_SURFACE_READER);
}

Result<MeshFile> aboutFile(const std::filesystem::path& file, Errc code, const std::string& fault)
{
    return fail(code, file.string() + ": " + fault);
}

} // namespace

SurfaceReader::SurfaceReader(std::chrono::milliseconds limitPerFile) : m_limitPerFile(limitPerFile)
{
}

SurfaceReader::~SurfaceReader() { stop(); }

void SurfaceReader::stop()
{
    if (!m_process)
        return;
    m_process->kill();
    m_process->waitForFinished();
    m_process.reset();
}

Result<void> SurfaceReader::start()
{
    if (m_process)
        return {};
    m_process = std::make_unique<QProcess>();
    m_process->setStandardErrorFile(QProcess::nullDevice());
    m_process->start(readerProgram(), QStringList{});
    if (m_process->waitForStarted())
        return {};
    m_process.reset();
    return fail(Errc::FileUnreadable, "the program that reads surfaces cannot be started");
}

Result<std::vector<std::byte>> SurfaceReader::answerTo(const std::filesystem::path& file)
{
    const std::string path = file.string();
    std::vector<std::byte> request;
    ByteWriter{request}.number(static_cast<std::uint64_t>(path.size()));
    m_process->write(reinterpret_cast<const char*>(request.data()), qint64(request.size()));
    m_process->write(path.data(), qint64(path.size()));

    const QDeadlineTimer deadline{m_limitPerFile};
    QByteArray answer;
    std::uint64_t length = 0;
    while (length == 0 || std::uint64_t(answer.size()) < sizeof length + length) {
        if (deadline.hasExpired())
            return fail(Errc::FileMalformed, "reading it takes too long");
        if (!m_process->waitForReadyRead(int(deadline.remainingTime()))
            && m_process->state() != QProcess::Running)
            return fail(Errc::FileMalformed, "its format library fails on it");
        answer += m_process->readAllStandardOutput();
        if (length == 0 && std::size_t(answer.size()) >= sizeof length)
            length = ByteReader{std::as_bytes(std::span{answer.constData(), sizeof length})}
                         .number<std::uint64_t>();
        if (length > kLongestAnswer)
            return fail(Errc::FileMalformed, "it holds more than can be read");
    }
    const auto bytes = std::as_bytes(std::span{answer.constData(), std::size_t(answer.size())});
    return std::vector<std::byte>{bytes.begin() + sizeof length, bytes.end()};
}

Result<MeshFile> SurfaceReader::read(const std::filesystem::path& file)
{
    if (const auto started = start(); !started)
        return aboutFile(file, started.error().code, started.error().detail);
    const auto answer = answerTo(file);
    auto read = answer ? decodeMeshFile(*answer) : tl::unexpected(answer.error());
    if (read)
        return std::move(*read);
    stop();
    return aboutFile(file, read.error().code, read.error().detail);
}

} // namespace carina
