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

/// A site and its file. What is shown is what is in the file: a change counts once it is kept
/// there, and each can be undone as a whole.
class SiteEditor : public QObject
{
    Q_OBJECT

public:
    using Today = std::function<QDateTime()>;

    /// @param site as the file has it
    SiteEditor(std::filesystem::path file, Site site, Today today);

    [[nodiscard]] const Site& site() const { return m_site; }
    [[nodiscard]] QDateTime today() const { return m_today(); }
    /// ISO 8601, in UTC.
    [[nodiscard]] std::string now() const;

    /// Takes a change over, which can then be undone.
    /// @returns false where it cannot be kept: the site stays as it is, and problem() says why.
    bool become(Site next);
    /// Shows a page, whatever the disk says. No change that undo knows.
    void enter(SiteStep step);

    [[nodiscard]] bool canUndo() const { return !m_past.empty(); }
    void undo();

    /// What went wrong last, in a sentence; empty since something went right.
    [[nodiscard]] QString problem() const { return m_problem; }
    void refuse(const Error& error);
    void refuse(const QString& sentence);

    /// What was done last beside the site, in a sentence; empty since something else happened.
    [[nodiscard]] QString notice() const { return m_notice; }
    void confirm(const QString& sentence);

    /// Something was achieved by hand, away from the screen: to be heard.
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
    std::vector<Site> m_past; ///< what undo goes back to
    QString m_problem;
    QString m_notice;
};

} // namespace carina
