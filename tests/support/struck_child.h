#pragma once

#include "tests/support/scratch_folder.h"

#include <QCoreApplication>
#include <QProcess>
#include <QString>
#include <QTest>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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

/// The kinds of faults, as rows of a test.
inline void addFaultKinds()
{
    QTest::addColumn<QString>("kind");
    for (const char* kind : {"once", "lasting", "short", "killed"})
        QTest::newRow(kind) << QString::fromLatin1(kind);
}

/// Strikes each call of an entry in turn, over a new folder each time, until it makes no more.
/// @param verify checks the folder and what the child told
/// @returns how many calls were struck; nothing where a check failed, or they never end
inline std::optional<int>
strikeEach(const QString& entry, const QString& kind,
           const std::function<void(const std::filesystem::path&, const StruckChild&)>& verify)
{
    constexpr int kMostCalls = 400;
    for (int at = 1; at < kMostCalls; ++at) {
        const QTemporaryDir folder{fastFolder()};
        const auto child = runStruck(entry, folder.path(), kind, at);
        if (child)
            verify(folder.path().toStdString(), *child);
        if (!child || QTest::currentTestFailed()) {
            qWarning("call %d", at);
            return std::nullopt;
        }
        if (!child->isStruck)
            return at - 1;
    }
    return std::nullopt;
}

/// What a child told of something, in order.
inline std::vector<std::string> allTold(const StruckChild& child, const QByteArray& what)
{
    std::vector<std::string> all;
    for (const QByteArray& line : child.told)
        if (line.startsWith(what + ' '))
            all.push_back(line.mid(what.size() + 1).toStdString());
    return all;
}

} // namespace carina::test
