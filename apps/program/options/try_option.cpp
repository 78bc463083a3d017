#include "apps/program/options/try_option.h"

#include "engine/io/scoring/rubric_file.h"

#include <QCoreApplication>

#include <algorithm>

namespace carina::program
{
namespace
{

const QString kRubric = QStringLiteral("rubric");
const QString kDepthRule = QStringLiteral("depth-rule");

QString tryOptionWords(const char* text) { return QCoreApplication::translate("TryOption", text); }

QString depthRuleWords()
{
    QStringList words;
    for (const char* word : kDepthRuleWords)
        words += QString::fromLatin1(word);
    return words.join(QStringLiteral(", "));
}

Result<DepthRule> depthRuleNamed(const std::string& word)
{
    const auto found = std::ranges::find(kDepthRuleWords, word);
    if (found == kDepthRuleWords.end())
        return fail(Errc::WrongOption,
                    "--depth-rule takes one of " + depthRuleWords().toStdString());
    return kDepthRules.at(std::size_t(found - kDepthRuleWords.begin()));
}

} // namespace

void addTryOptions(QCommandLineParser& parser)
{
    parser.addOption({kRubric,
                      tryOptionWords("Judge tries at intubating by the rubric in this file (JSON), "
                                     "in place of the published one."),
                      QStringLiteral("FILE")});
    parser.addOption({kDepthRule,
                      tryOptionWords("The rule for the depth of the tube: %1. Without it the one "
                                     "that is usual for the patient's age.")
                          .arg(depthRuleWords()),
                      QStringLiteral("RULE")});
}

Result<void> readTryOptions(const QCommandLineParser& parser, TryWatch& tries)
{
    if (parser.isSet(kDepthRule)) {
        const auto rule = depthRuleNamed(parser.value(kDepthRule).toStdString());
        if (!rule)
            return tl::unexpected(rule.error());
        tries.setRule(*rule);
    }
    if (parser.isSet(kRubric)) {
        auto rubric = readRubricFile(parser.value(kRubric).toStdString());
        if (!rubric)
            return tl::unexpected(rubric.error());
        tries.setRubric(*std::move(rubric));
    }
    return {};
}

} // namespace carina::program
