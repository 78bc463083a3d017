#pragma once

#include "engine/core/session_time.h"
#include "models/session/session_plan.h"

#include <QAbstractListModel>
#include <QDateTime>
#include <QStringList>
#include <QThreadPool>

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace carina
{

/// A session in a file, as far as a person needs it to choose one.
struct StoredSession {
    QString file{};
    QDateTime began{}; ///< by the name of the file
    QString name{};
    QString patient{};         ///< of its first open station
    std::string anatomyHash{}; ///< likewise
    QStringList people{};      ///< who took part, without who hosted it
    Duration running{};
    SessionReach reach = SessionReach::ThisComputer; ///< in which it was hosted last
    bool hasEnded = false;
    QString fault{}; ///< why it cannot be read; nothing else is known of it then
};

/// The files of sessions in a folder, those that began last first.
[[nodiscard]] QStringList sessionFiles(const QString& folder);

/// Keeps beside the file of a session who could join it, so that it is resumed for the same people;
/// where that fails it is resumed for this computer.
void keepReach(const QString& file, SessionReach reach);

/// Reads the session in a file; another program that has it open keeps it.
[[nodiscard]] StoredSession storedSession(const QString& file);

/// All sessions in a folder that have not ended, the last ones first; read on another thread.
class StoredSessionsModel : public QAbstractListModel
{
    Q_OBJECT

public:
    /// Begins to read.
    explicit StoredSessionsModel(QString folder, QObject* parent = nullptr);
    /// Waits until no file is open.
    ~StoredSessionsModel() override;

    /// Whether all were read.
    [[nodiscard]] bool isComplete() const { return m_isComplete; }
    /// Begins to read anew.
    void read();
    /// Reads no further file, and returns when none is open: then a session can be opened.
    void stop();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// A session that cannot be read cannot be chosen.
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// @pre row is one of rowCount().
    [[nodiscard]] const StoredSession& at(int row) const;

Q_SIGNALS:
    /// isComplete() is true from now on.
    void completed();

private:
    void take(const StoredSession& session);
    void tell(int run, std::function<void()> found);

    const QString m_folder;
    std::vector<StoredSession> m_sessions;
    bool m_isComplete = false;
    std::atomic<int> m_run{0}; ///< of reading; an earlier one goes no further
    QThreadPool m_reader;
};

} // namespace carina
