// Any bytes as a rubric: refused with a reason, or read as one that is written and read again.

#include "engine/core/expects.h"
#include "engine/io/scoring/rubric_file.h"

#include <QJsonDocument>

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carina;
    const auto rubric = rubricIn({reinterpret_cast<const char*>(data), size});
    if (!rubric) {
        CARINA_EXPECTS(!rubric.error().detail.empty());
        return 0;
    }
    CARINA_EXPECTS(!rubric->criteria.empty() && rubric->criteria.size() <= kMostCriteria);
    const std::string text = QJsonDocument{jsonRubric(*rubric)}.toJson().toStdString();
    CARINA_EXPECTS(rubricIn(text).value() == *rubric);
    return 0;
}
