// Tests of messages: which of them disappear by themselves.
#include "app/document/message.h"

#include <new>

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("a notice goes some time after it was seen last, a fault never does") {
    const Message notice{.text = "done", .kind = MessageKind::notice, .seen = 5};
    CHECK_FALSE(is_over(notice, 5 + notice_time / 2));
    CHECK(is_over(notice, 5 + 1.1 * notice_time));
    CHECK_FALSE(notice.is_fault());
    const Message fault{.text = "wrong"};
    CHECK(fault.is_fault());
    CHECK_FALSE(is_over(fault, 1e9));
    CHECK_FALSE(is_over({}, 1e9));
    CHECK_FALSE(Message{}.is_fault());
}

TEST_CASE("what nothing was prepared for is a fault that says what it was, in words where it has none") {
    CHECK(message_of_mishap(std::bad_alloc()).is_fault());
    CHECK(message_of_mishap(std::bad_alloc()).text.find("not enough memory") != std::string::npos);
    CHECK(message_of_mishap(std::runtime_error("the cause")).text.find("the cause") != std::string::npos);
}
