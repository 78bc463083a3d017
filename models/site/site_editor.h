#pragma once

#include "engine/core/result.h"
#include "engine/io/site/site.h"

#include <QDateTime>
#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <vector>

namespace carina
{

/// A site and its file. A change takes effect only after it was written to the file, and each can
/// be undone as a whole.
class SiteEditor : public QObject
{
    Q_OBJECT

public:
    using Today = std::function<QDateTime()>;

    /// @param site as read from the file
    /// @param past what the site was before, oldest first, for undo()
    SiteEditor(std::filesystem::path file, Site site, Today today, std::vector<Site> past = {});

    [[nodiscard]] const Site& site() const { return m_site; }
    [[nodiscard]] QDateTime today() const { return m_today(); }
    /// ISO 8601, in UTC.
    [[nodiscard]] std::string now() const;

    /// Writes the changed site to the file and adopts it; can be undone.
    /// @returns false if it cannot be written: the site stays as it is, and problem() says why.
    bool become(Site next);
    /// Goes to a page, even if that cannot be written to the file. Not a change for undo().
    void enter(SiteStep step);

    [[nodiscard]] bool canUndo() const { return !m_past.empty(); }
    [[nodiscard]] const std::vector<Site>& past() const { return m_past; }
    void undo();

    /// One sentence: the last failure; empty after a success.
    [[nodiscard]] QString problem() const { return m_problem; }
    void refuse(const Error& error);
    void refuse(const QString& sentence);

    /// One sentence: the last action outside the site, such as an export; empty after any other
    /// event.
    [[nodiscard]] QString notice() const { return m_notice; }
    void confirm(const QString& sentence);

    /// Something was done with the stylus, away from the screen: to be spoken aloud.
    void tell(const QString& words) { Q_EMIT told(words); }

Q_SIGNALS:
    /// The site, its page, the problem or the notice changed.
    void changed();
    void told(const QString& words);

private:
    bool keep(Site next);

    std::filesystem::path m_file;
    Site m_site;
    Today m_today;
    std::vector<Site> m_past; ///< earlier sites, for undo()
    QString m_problem;
    QString m_notice;
};

} // namespace carina
