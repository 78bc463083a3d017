#pragma once

#include "engine/core/result.h"
#include "evaluation/network/virtual_link.h"

#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <filesystem>

namespace carina
{

/// The program netlab at work: an emulator that runs every program in its own network namespace,
/// which requires root privileges. It ends with this.
class NetlabProcess
{
public:
    /// The address of the host that is named first in a configuration.
    static constexpr const char* kFirstAddress = "10.77.0.1";

    explicit NetlabProcess(QString program) : m_program{std::move(program)} {}
    ~NetlabProcess();
    NetlabProcess(const NetlabProcess&) = delete;
    NetlabProcess& operator=(const NetlabProcess&) = delete;

    /// Starts it with the lines of a configuration.
    /// @returns NotPermitted if it cannot be started; FileUnwritable.
    [[nodiscard]] Result<void> start(const QStringList& lines);
    /// A folder that is there as long as this.
    [[nodiscard]] std::filesystem::path folder() const;
    /// The command line that runs a program at one of its hosts.
    [[nodiscard]] QStringList inPlace(const QString& host, const QStringList& program) const;
    /// Has it follow a statement from now on; returns at once.
    void tell(const QString& statement) const;

private:
    QString m_program;
    QString m_name;
    QTemporaryDir m_folder;
    QProcess m_lab;
};

/// One way of a link, as netlab's words.
///
/// @param hasStepped whether the step of the delay (PathProfile::stepAt) has occurred
/// @param trace file with the trace of the way, if it has one
[[nodiscard]] QString netlabWay(const PathProfile& way, bool hasStepped,
                                const std::filesystem::path& trace);

} // namespace carina
