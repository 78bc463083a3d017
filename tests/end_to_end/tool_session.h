#pragma once

#include "engine/net/devices/any_recording.h"
#include "tests/end_to_end/program.h"

#include <QTemporaryDir>

namespace carina
{

/// A place registered by a pure shift: the patient lies 10, 20, 30 mm from the tracker's origin.
inline const QByteArray kShiftedSite = R"({"schema": "carina.site/2", "step": "overview",
 "catalogue": {"name": "three", "landmarks": [{"name": "a", "p_AQ_mm": [0, 0, 1]},
  {"name": "b", "p_AQ_mm": [0, 1, 0]}, {"name": "c", "p_AQ_mm": [1, 0, 0]}]},
 "registration": {"X_AM_mm": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
  "X_AT_mm": [[1, 0, 0, 10], [0, 1, 0, 20], [0, 0, 1, 30], [0, 0, 0, 1]],
  "rms_mm": 0.1, "residuals_mm": [{"name": "a", "mm": 0.1}]}})";
inline const Vec3 kShift_mm{10.0, 20.0, 30.0};

/// A session whose programs can play a recording of tools at a registered place, and are worked by
/// a script; all its files are in one folder.
class ToolSession
{
public:
    /// @returns whether the files are written
    [[nodiscard]] bool prepare(const TrackerSequence& tools)
    {
        QFile site{path("site.json")};
        m_script.setFileName(path("script"));
        return site.open(QIODevice::WriteOnly) && site.write(kShiftedSite) == kShiftedSite.size()
               && writeAnyRecording(path("tools.csv").toStdString(), tools).has_value()
               && m_script.open(QIODevice::Append);
    }

    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder.filePath(QLatin1String{name});
    }

    [[nodiscard]] Program instructor(const QStringList& more) const
    {
        return Program{QStringLiteral(CARINA_INSTRUCTOR),
                       QStringList{QStringLiteral("--port"), portOfThisTest(),
                                   QStringLiteral("--data"), path("host"),
                                   QStringLiteral("--codes"), path("codes")}
                           + more,
                       path("instructor.jsonl")};
    }
    [[nodiscard]] Program trainee(const char* name, const QStringList& more) const
    {
        const QString own = QLatin1String{name};
        return Program{QStringLiteral(CARINA_TRAINEE),
                       QStringList{QStringLiteral("--port"), portOfThisTest(),
                                   QStringLiteral("--as"), own, QStringLiteral("--code-file"),
                                   path("codes"), QStringLiteral("--data"), path(name)}
                           + more,
                       m_folder.filePath(own + QStringLiteral(".jsonl"))};
    }

    /// Has the program whose `--script` is path("script") do what these lines say.
    void work(const QByteArray& lines)
    {
        m_script.write(lines);
        m_script.flush();
    }
    /// The recording, as a person chooses it in the running program.
    void useRecording()
    {
        work("press connectTracker\npress source2\ntype recording " + path("tools.csv").toUtf8()
             + "\npress looped\npress use\n");
    }

private:
    QTemporaryDir m_folder;
    QFile m_script;
};

} // namespace carina
