#pragma once

#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

namespace carina::test
{

/// Whether the programs of the Debian package poppler-utils, which read a PDF below, are there.
inline bool hasPdfReader()
{
    return !QStandardPaths::findExecutable(QStringLiteral("pdftotext")).isEmpty();
}

/// What such a program prints; nothing where it fails.
inline QString printedBy(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished() || process.exitCode() != 0)
        return {};
    return QString::fromUtf8(process.readAllStandardOutput());
}

/// The words of each page, with one space between them.
inline QStringList pagesOf(const QString& file)
{
    QStringList pages = printedBy(QStringLiteral("pdftotext"),
                                  {QStringLiteral("-layout"), file, QStringLiteral("-")})
                            .split(QLatin1Char{'\f'});
    pages.removeLast(); // what follows the last form feed
    for (QString& page : pages)
        page = page.simplified();
    return pages;
}

/// A property as pdfinfo tells it, such as "Pages".
inline QString propertyOf(const QString& file, const QString& name)
{
    const QRegularExpression line{QStringLiteral("^%1: +(.*)$").arg(name),
                                  QRegularExpression::MultilineOption};
    return line.match(printedBy(QStringLiteral("pdfinfo"), {file})).captured(1);
}

/// The first page as it is printed.
inline QImage firstPageOf(const QString& file, int dotsPerInch)
{
    const QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("page"));
    printedBy(QStringLiteral("pdftoppm"),
              {QStringLiteral("-png"), QStringLiteral("-singlefile"), QStringLiteral("-r"),
               QString::number(dotsPerInch), file, name});
    return QImage{name + QStringLiteral(".png")};
}

} // namespace carina::test
