#pragma once

#include <QCoreApplication>
#include <QProcess>
#include <QString>

#include <optional>

namespace carina::test
{

/// What a child told whose writes and syncs were struck.
struct StruckChild {
    QByteArrayList told; ///< its lines
    bool isStruck;       ///< false: it made fewer calls
};

/// Runs an entry of this test program over a folder while the at-th of its calls that write or sync
/// a file there is struck, see file_faults.cpp.
/// @param kind as CARINA_FAULT_KIND @returns nothing where it crashed or failed
inline std::optional<StruckChild> runStruck(const QString& entry, const QString& folder,
                                            const QString& kind, int at)
{
    QProcessEnvironment around = QProcessEnvironment::systemEnvironment();
    around.insert(QStringLiteral("LD_PRELOAD"), QStringLiteral(CARINA_FILE_FAULTS));
    around.insert(QStringLiteral("CARINA_FAULT_IN"), folder);
    around.insert(QStringLiteral("CARINA_FAULT_KIND"), kind);
    around.insert(QStringLiteral("CARINA_FAULT_AT"), QString::number(at));
    around.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("verify_asan_link_order=0"));
    QProcess child;
    child.setProcessEnvironment(around);
    child.start(QCoreApplication::applicationFilePath(), {entry, folder});
    if (!child.waitForFinished(60'000))
        return std::nullopt;
    const bool isWell = child.exitStatus() == QProcess::NormalExit && child.exitCode() == 0;
    const bool isKilled =
        child.exitStatus() == QProcess::CrashExit && kind == QStringLiteral("killed");
    if (!isWell && !isKilled)
        return std::nullopt;
    return StruckChild{child.readAllStandardOutput().split('\n'),
                       child.readAllStandardError().contains("fault: ")};
}

} // namespace carina::test
