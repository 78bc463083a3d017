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
    [[nodiscard]] std::vector<SavedView> views() const;
    void keepViews(const std::vector<SavedView>& views);

private:
    QString m_file;
};

} // namespace carina
