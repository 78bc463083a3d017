#pragma once

#include "models/console/saved_views.h"

#include <QByteArray>

namespace carina
{

/// What the console remembers from one start to the next, in a file of the folder that the sessions
/// are stored in. What cannot be read, or was written for other panels, is as if it were not there.
class KeptConsole
{
public:
    /// @param folder an empty one: nothing is remembered
    explicit KeptConsole(const QString& folder);

    /// Where the panels are, as QMainWindow::saveState has it; empty where nothing is kept.
    [[nodiscard]] QByteArray panels() const;
    void keepPanels(const QByteArray& panels);
    /// The group whose events the panel Airway has in sight; empty where nothing is kept.
    [[nodiscard]] QByteArray airwayGroup() const;
    void keepAirwayGroup(const QByteArray& name);
    [[nodiscard]] std::vector<SavedView> views() const;
    void keepViews(const std::vector<SavedView>& views);

private:
    [[nodiscard]] QByteArray bytes(const QString& key) const;
    void keep(const QString& key, const QByteArray& value);

    QString m_file;
};

} // namespace carina
