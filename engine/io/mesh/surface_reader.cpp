#include "engine/io/mesh/surface_reader.h"

#include "engine/core/byte_buffer.h"
#include "engine/io/files/file_limit.h"
#include "engine/io/files/folder_path.h"
#include "engine/io/mesh/mesh_file_codec.h"
#include "engine/io/mesh/reader_memory.h"
#include "engine/io/mesh/surface_reader_exit.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QFileInfo>
#include <QProcess>
#include <QStringList>

#include <algorithm>
#include <array>
#include <csignal>
#include <new>
#include <span>
#include <utility>
#include <vector>

namespace carina
{
namespace
{

constexpr const char* kTooMuch = "it holds more than can be read";
constexpr int kPatience = 10; ///< files that others may read before this one has its turn

/// Beside the running program as in a package, else where it was built.
QString readerProgram()
{
    const QString beside =
        QCoreApplication::applicationDirPath() + QStringLiteral("/carina-surface-reader");
    return QFileInfo::exists(beside) ? beside : QStringLiteral(CARINA_SURFACE_READER);
}

/// Of an answer that may be as long as it likes, and of any content.
Result<Result<MeshFile>> decoded(std::span<const std::byte> bytes)
try {
    return decodeMeshFile(bytes);
} catch (const std::bad_alloc&) {
    return fail(Errc::FileTooLarge, kTooMuch);
}

Result<MeshFile> aboutFile(const std::filesystem::path& file, Errc code, const std::string& fault)
{
    return fail(code, file.string() + ": " + fault);
}

} // namespace

SurfaceReader::SurfaceReader(std::chrono::milliseconds limitPerFile) : m_limitPerFile(limitPerFile)
{
}

SurfaceReader::SurfaceReader(std::filesystem::path folder, std::chrono::milliseconds limitPerFile)
    : m_limitPerFile(limitPerFile), m_common(std::move(folder))
{
}

SurfaceReader::~SurfaceReader() { stop(); }

void SurfaceReader::stop()
{
    if (m_process) {
        m_process->kill();
        m_process->waitForFinished();
        m_process.reset();
    }
    ReaderMemory::giveBack(std::exchange(m_shares, 0));
}

Result<void> SurfaceReader::start(const std::filesystem::path& folder, unsigned shares)
{
    const bool tired = m_spent >= m_limitPerFile;
    if (m_process && m_folder == folder && m_shares >= shares && !tired)
        return {};
    stop();
    if (!ReaderMemory::take(shares, kPatience * m_limitPerFile))
        return fail(Errc::FileUnreadable, "too many other files are being read");
    m_shares = shares;
    m_folder = folder;
    m_spent = {};
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(2 * m_limitPerFile);
    m_process = std::make_unique<QProcess>();
    m_process->setStandardErrorFile(QProcess::nullDevice());
    m_process->start(readerProgram(), {QString::fromStdString(folder.string()),
                                       QString::number(ReaderMemory::bytesOf(shares)),
                                       QString::number(std::max<std::int64_t>(1, seconds.count())),
                                       QString::number(QCoreApplication::applicationPid())});
    if (m_process->waitForStarted())
        return {};
    stop();
    return fail(Errc::FileUnreadable, "the program that reads surfaces cannot be started");
}

Error SurfaceReader::whyItEnded() const
{
    const int code = m_process->exitCode(); // or the signal that ended it
    if (m_process->exitStatus() == QProcess::CrashExit) {
        if (code == SIGSYS)
            return {Errc::FileMalformed, "its reader was ended because it asked for what a reader "
                                         "may not do: the file may be an attack"};
        if (code == SIGXCPU)
            return {Errc::FileMalformed, "reading it takes too much processor time"};
        return {Errc::FileMalformed, "its format library fails on it"};
    }
    if (code == reader_exit::kOutOfMemory)
        return {Errc::FileTooLarge, "reading it takes more than "
                                        + std::to_string(ReaderMemory::bytesOf(m_shares) >> 20U)
                                        + " MiB of memory"};
    if (code == reader_exit::kNotConfined)
        return {Errc::NotConfined, "the program that reads surfaces cannot be confined"};
    return {Errc::FileMalformed, "its format library ended its reader"};
}

Result<void> SurfaceReader::hear(std::span<std::byte> whole, const QDeadlineTimer& deadline)
{
    std::size_t heard = 0;
    while (heard < whole.size()) {
        const auto rest = whole.subspan(heard);
        const qint64 more =
            m_process->read(reinterpret_cast<char*>(rest.data()), qint64(rest.size()));
        if (more > 0) {
            heard += std::size_t(more);
            continue;
        }
        if (deadline.hasExpired())
            return fail(Errc::FileMalformed, "reading it takes too long");
        if (!m_process->waitForReadyRead(int(deadline.remainingTime()))
            && m_process->state() != QProcess::Running)
            return tl::unexpected(whyItEnded());
    }
    return {};
}

SurfaceReader::Answer SurfaceReader::answerTo(const std::filesystem::path& file)
{
    const std::string path = file.string();
    std::vector<std::byte> request;
    ByteWriter{request}.number(static_cast<std::uint64_t>(path.size()));
    m_process->write(reinterpret_cast<const char*>(request.data()), qint64(request.size()));
    m_process->write(path.data(), qint64(path.size()));

    const QDeadlineTimer deadline{m_limitPerFile};
    std::array<std::byte, sizeof(std::uint64_t)> header{};
    if (const auto heard = hear(header, deadline); !heard)
        return tl::unexpected(heard.error());
    // A reader that was taken over may announce and send anything, without end. What it does not
    // send takes no memory: the pages are not touched before it comes.
    const auto length = ByteReader{header}.number<std::uint64_t>();
    AnswerBytes answer;
    if (length <= ReaderMemory::longestAnswer(m_shares))
        answer = {std::unique_ptr<std::byte[]>{new (std::nothrow) std::byte[length]},
                  std::size_t{length}};
    if (!answer.bytes)
        return fail(Errc::FileTooLarge, kTooMuch);
    if (const auto heard = hear({answer.bytes.get(), answer.size}, deadline); !heard)
        return tl::unexpected(heard.error());
    if (m_process->bytesAvailable() > 0)
        return fail(Errc::FileTooLarge, kTooMuch);
    m_spent += m_limitPerFile - std::chrono::milliseconds{deadline.remainingTime()};
    return answer;
}

SurfaceReader::Answer SurfaceReader::attempt(const std::filesystem::path& file, unsigned shares)
{
    const auto folder = m_common.empty() ? file.parent_path() : m_common;
    if (const auto started = start(folder, shares); !started)
        return tl::unexpected(started.error());
    auto answer = answerTo(file);
    if (!answer || shares > 1 || ReaderMemory::isWantedWhole())
        stop();
    return answer;
}

Result<MeshFile> SurfaceReader::read(const std::filesystem::path& file)
{
    // Both are said again by the program that reads it, but here it costs no program.
    const auto good =
        pathWithin(file.parent_path(), file.filename()).and_then([](const auto& found) {
            return readableSize(found, kSurfaceLimit);
        });
    if (!good)
        return tl::unexpected(good.error());
    std::error_code error;
    const auto absolute = std::filesystem::absolute(file, error);
    const auto path = std::filesystem::canonical(absolute.parent_path(), error) / file.filename();
    auto answer = attempt(path, 1);
    if (!answer && answer.error().code == Errc::FileTooLarge)
        answer = attempt(path, ReaderMemory::shares());
    auto read = answer.and_then([](const AnswerBytes& bytes) {
        return decoded({bytes.bytes.get(), bytes.size});
    });
    if (read)
        return std::move(*read);
    stop();
    return aboutFile(file, read.error().code, read.error().detail);
}

} // namespace carina
