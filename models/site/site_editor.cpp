#include "models/site/site_editor.h"

#include "engine/io/site/site_file.h"
#include "models/errors/error_text.h"

namespace carina
{

SiteEditor::SiteEditor(std::filesystem::path file, Site site, Today today, std::vector<Site> past)
    : m_file{std::move(file)},
      m_site{std::move(site)},
      m_today{std::move(today)},
      m_past{std::move(past)}
{
}

std::string SiteEditor::now() const
{
    return m_today().toUTC().toString(Qt::ISODate).toStdString();
}

bool SiteEditor::become(Site next)
{
    Site past = m_site;
    if (!keep(std::move(next)))
        return false;
    m_past.push_back(std::move(past));
    Q_EMIT changed();
    return true;
}

void SiteEditor::enter(SiteStep step)
{
    Site next = m_site;
    next.step = step;
    if (!keep(std::move(next)))
        m_site.step = step;
    Q_EMIT changed();
}

void SiteEditor::undo()
{
    if (m_past.empty() || !keep(m_past.back()))
        return;
    m_past.pop_back();
    Q_EMIT changed();
}

void SiteEditor::refuse(const Error& error) { refuse(errorText(error)); }

void SiteEditor::refuse(const QString& sentence)
{
    m_problem = sentence;
    m_notice.clear();
    Q_EMIT changed();
}

void SiteEditor::confirm(const QString& sentence)
{
    m_problem.clear();
    m_notice = sentence;
    Q_EMIT changed();
}

bool SiteEditor::keep(Site next)
{
    if (const auto written = writeSiteFile(m_file, next); !written) {
        refuse(written.error());
        return false;
    }
    m_site = std::move(next);
    m_problem.clear();
    m_notice.clear();
    return true;
}

} // namespace carina
